// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberReader
 * @brief   read surfaces and points from files of many formats, in full or not at all
 *
 * The reader gives vtkPolyData with the points and the polygons of the file as they are, in the
 * order of the file. The suffix of the file's name, in small letters or capital ones, says which
 * format it has.
 *
 * - PLY (.ply), as text or in either order of bytes: vertices, and faces; at
 *   the vertices, where there are any, normals "Normals", colours "RGB" or "RGBA" as bytes,
 *   whatever their numbers are in the file (red green blue, diffuse_red …, or r g b), and texture
 *   coordinates "TCoords" in single precision, as vtkPLYReader names them. Strips of
 *   triangles (tristrips) become triangles. With ReadAllColumns other single numbers of vertices,
 *   and of faces where these are of one element, become arrays, of integers where the file has
 *   these, and so do colours of faces. Other elements and properties are passed over.
 * - STL (.stl), as text or binary: the triangles of all solids, each with three points of its own,
 *   in the order of the file. The filters of FiltersWinding weld them; others may need
 *   vtkStaticCleanPolyData. The normals of facets and all attributes are passed over.
 * - Wavefront (.obj): vertices, faces, lines and points. Point normals "Normals" where there are as
 *   many as vertices and no corner names the normal of another vertex. Colours behind positions
 *   become "RGB", white for vertices without, and objects, groups and materials numbers of faces,
 *   with their names in the field data. With ReadAllColumns texture coordinates become "TCoords": a
 *   vertex is there once for each that its corners name. Free-form geometry is passed over.
 * - Geomview's Object File Format (.off), as text: the keyword OFF with the prefixes ST, C and N in
 *   any order, the counts on the same line or the next, comments from '#' on, one vertex and one
 *   face on a line. Faces with two corners become lines, those with one become vertices; a file
 *   without faces gives one cell of all its points. Vertex normals (NOFF) become "Normals"; colours
 *   and texture coordinates are passed over. Binary files are refused, and so are the prefixes 4
 *   and n (other dimensions).
 * - Points (.xyz, .pwn), one on a line, as `x y z` or `x y z nx ny nz`, the same on all lines, with
 *   comments from '#' on. The first line may be the number of points; the normals may then also
 *   stand in lines of their own after all positions, as the classic .pwn has it: n, n lines of
 *   `x y z`, n lines of `nx ny nz`. Columns that are named in a line before all others may be any.
 *   Three columns of colours behind the position become "RGB". Commas or semicolons may separate
 *   numbers. All points are in one cell, so that they can be seen.
 * - Tables of points, with commas (.csv), tabs (.tsv) or semicolons. See below.
 *
 * Files of all of these formats may be packed by gzip, with .gz behind their suffix. They are
 * unpacked into memory, which is refused where less is free.
 *
 * Geometry that a file has and that is not read is a warning, and so are colours of points.
 *
 * Points are in double precision where the file holds more digits than single precision has: in all
 * text, and where PLY has numbers of type double or integers of four bytes. So are normals. They
 * are the active ones and as the file has them, whatever their length.
 *
 * The first row of a table names its columns, and each other one is a point:
 *
 * - x, y and z are the positions, and must be there;
 * - nx, ny and nz become the active point normals "Normals";
 * - area becomes the point data array "Area", which vtkWindingNumberField takes for the areas of
 *   the points;
 * - vp_x, vp_y and vp_z, or viewpoint_x and so on, become "Viewpoints": estimated normals look from
 *   the points to these places, where they were seen from;
 * - all other columns become point data arrays of their names with ReadAllColumns: vtkDoubleArray
 *   where all fields are numbers, vtkStringArray otherwise. A column without a name becomes Column
 *   and its number, from 1 on; where another array has the name, the number stands behind it.
 *
 * These names may have small letters or large ones, and a unit in brackets. Positions may also be
 * easting, northing and elevation, height or altitude. Positions and normals may also have the
 * names that ParaView gives to components when it saves data as a table, "Points:0" to "Points:2"
 * and "Normals:0" to "Normals:2"; where a table has both, ParaView's count. Of several columns with
 * one such name the first counts, and the ones behind it are like all others.
 *
 * Fields may be in quotation marks, as RFC 4180 has it, with separators, ends of lines and doubled
 * quotation marks in them. Lines may end in "\n" or "\r\n", blank lines are no rows, and a byte
 * order mark is passed over. Empty fields of positions, normals and areas are NaN. A quotation mark
 * that is not closed makes the rest of the file one row, which is then refused.
 *
 * The file is read by as many threads as vtkSMPTools has, and the result is the same for any number
 * of them. It takes little memory in addition to the output, unless rows are kept.
 *
 * Errors, each one line through vtkErrorMacro with the name of the file, and its line where it is
 * text, with the error code set and the output empty: files that cannot be read, are empty,
 * truncated or hold anything else; counts that the file cannot hold, which are refused before
 * anything is allocated; corners that name what does not exist; tables without columns x, y and z,
 * rows with more or fewer fields than there are columns, and fields that should be numbers and are
 * none. NaN and infinite numbers are read as they are.
 *
 * @sa vtkWindingNumberField vtkWindingNumberProbe vtkPCANormalEstimation
 */
#ifndef vtkWindingNumberReader_h
#define vtkWindingNumberReader_h

#include "vtkIOWindingModule.h" // for export macro
#include "vtkNew.h"             // for ColumnNames
#include "vtkPolyDataAlgorithm.h"
#include "vtkWindingABINamespace.h"

#include <memory> // for the table
#include <string> // for the header

namespace winding
{
class ColumnChoice;
class Executor;
class InputFile;
struct PointTable;
} // namespace winding

VTK_ABI_NAMESPACE_BEGIN
class vtkStringArray;

class VTKIOWINDING_EXPORT vtkWindingNumberReader : public vtkPolyDataAlgorithm
{
public:
  static vtkWindingNumberReader* New();
  vtkTypeMacro(vtkWindingNumberReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The names that messages give properties, of vtkWindingNumberAlgorithm::NamesInMessagesType.
  /// Default CXX_NAMES.
  vtkSetMacro(NamesInMessages, int);
  vtkGetMacro(NamesInMessages, int);
  ///@}

  /// Returns the suffixes of all formats, with their dots and blanks between them.
  static const char* GetFileExtensions();

  ///@{
  /// The name of the file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * For tables and points (.csv, .tsv, .xyz, .pwn): the columns to take, as "x=Easting y=Northing
   * z=Height (m) nx=4 ny=5 nz=6 area=Patch vx=7 vy=8 vz=9". They are names, or numbers from 1 on
   * where no column has that name. What is not said goes by the names above. Where x, y and z are
   * numbers, and the first row has numbers in their columns, the file has no names; the columns are
   * then called Column 1, Column 2 and so on. A column that is not there, or is taken twice, is an
   * error. Default: none.
   */
  vtkSetStringMacro(Columns);
  vtkGetStringMacro(Columns);
  ///@}

  ///@{
  /// For tables: whether the columns nx, ny, nz, area and vp_x, vp_y and vp_z become arrays with a
  /// meaning. Otherwise they are columns like all others. Default: on.
  vtkSetMacro(ReadNormalsAndAreas, bool);
  vtkGetMacro(ReadNormalsAndAreas, bool);
  vtkBooleanMacro(ReadNormalsAndAreas, bool);
  ///@}

  ///@{
  /// For tables, points whose columns have names, .ply and .obj: whether columns other than
  /// positions, normals and areas are read, too. In .ply these are single numbers of vertices and
  /// faces, and in .obj texture coordinates. VTK looks
  /// through all arrays for each one that is added, so ten thousand columns take a second. Default:
  /// on.
  vtkSetMacro(ReadAllColumns, bool);
  vtkGetMacro(ReadAllColumns, bool);
  vtkBooleanMacro(ReadAllColumns, bool);
  ///@}

  ///@{
  /// For tables: whether GetRow() gives the text of each row, which then stays in memory. Default:
  /// off.
  vtkSetMacro(KeepRows, bool);
  vtkGetMacro(KeepRows, bool);
  vtkBooleanMacro(KeepRows, bool);
  ///@}

  /// Returns the row of `point` as it is in the file, without the end of its last line, after an
  /// update with KeepRows; empty otherwise.
  std::string GetRow(vtkIdType point) const;

  /// Returns the first row of a table as it is, with the end of its last line, after an update;
  /// empty where no table was read. Where the file ends with it, an end of line is added.
  std::string GetHeader() const;

  /// Returns the names of all columns in their order, as the first row has them, after an update;
  /// none where no table was read.
  vtkStringArray* GetColumnNames() { return this->ColumnNames; }

  /// Returns the letter between the fields of a table, a comma, a tab or a semicolon, after an
  /// update.
  char GetSeparator() const;

  /// Returns whether commas are the decimal points of a table that was read.
  bool GetHasDecimalCommas() const;

protected:
  vtkWindingNumberReader();
  ~vtkWindingNumberReader() override;

  vtkWindingNumberReader(const vtkWindingNumberReader&) = delete;
  void operator=(const vtkWindingNumberReader&) = delete;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int NamesInMessages = 0; // vtkWindingNumberAlgorithm::CXX_NAMES
  char* FileName = nullptr;
  char* Columns = nullptr;
  bool ReadNormalsAndAreas = true;
  bool ReadAllColumns = true;
  bool KeepRows = false;

private:
  winding::ColumnChoice ChosenColumns() const;
  void Read(const winding::InputFile& file, winding::Executor& executor, vtkPolyData* output);
  void ReadTable(const winding::InputFile& file, char separator, winding::Executor& executor,
    vtkPolyData* output);

  vtkNew<vtkStringArray> ColumnNames;
  std::unique_ptr<winding::PointTable> Table; ///< the header and the rows of the last file
};
VTK_ABI_NAMESPACE_END

#endif
