/**
 * @class   vtkPointTableReader
 * @brief   read points with normals and areas from a table (.csv, .tsv)
 *
 * The reader gives vtkPolyData with a point for each row of a text table, in double precision, and
 * one cell of all points, so that they can be seen. Fields are separated by commas, or by tabs in
 * files that end in .tsv. The first row names the columns:
 *
 * - x, y and z are the positions, and must be there;
 * - nx, ny and nz become the active point normals "Normals", as they are, whatever their length;
 * - area becomes the point data array "Area", which vtkWindingNumberField takes for the areas of
 *   the points;
 * - all other columns become point data arrays of their names with ReadAllColumns: vtkDoubleArray
 *   where all fields are numbers, vtkStringArray otherwise. A column without a name becomes Column
 *   and its number, from 1 on; where another array has the name, the number stands behind it.
 *
 * These names may have small letters or large ones. Positions and normals may also have the names
 * that ParaView gives to components when it saves data as a table, "Points:0" to "Points:2" and
 * "Normals:0" to "Normals:2"; where a table has both, ParaView's count. Of several columns with one
 * such name the first counts, and the ones behind it are like all others.
 *
 * Fields may be in quotation marks, as RFC 4180 has it, with separators, ends of lines and doubled
 * quotation marks in them. Lines may end in "\n" or "\r\n", blank lines are no rows, and a byte
 * order mark is passed over. Rows are read by all threads, and the result is the same for any
 * number of threads. Unless rows are kept, only parts of the text are in memory at a time, a quarter
 * of a megabyte for each thread, or a row where one is longer. A quotation mark that is not closed
 * makes the rest of the file one row, which is then refused.
 *
 * Errors, each one line through vtkErrorMacro with the name and the line of the file, with the
 * error code set and the output empty: files that cannot be read, are empty, have no columns x, y
 * and z, rows with more or fewer fields than there are columns, fields of positions, normals and
 * areas that are no numbers, and quotation marks that are not closed. NaN and infinite numbers are
 * read as they are.
 *
 * @sa vtkOrientedPointsReader vtkDelimitedTextReader vtkWindingNumberField vtkWindingNumberProbe
 */
#ifndef vtkPointTableReader_h
#define vtkPointTableReader_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkNew.h"                  // for ColumnNames
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the table
#include <string> // for the header

namespace winding
{
struct PointTable;
}

class vtkStringArray;

class VTKFILTERSWINDING_EXPORT vtkPointTableReader : public vtkPolyDataAlgorithm
{
public:
  static vtkPointTableReader* New();
  vtkTypeMacro(vtkPointTableReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The name of the file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /// Whether the columns nx, ny, nz and area become normals and areas. Otherwise they are columns
  /// like all others. Default: on.
  vtkSetMacro(ReadNormalsAndAreas, bool);
  vtkGetMacro(ReadNormalsAndAreas, bool);
  vtkBooleanMacro(ReadNormalsAndAreas, bool);
  ///@}

  ///@{
  /// Whether columns other than positions, normals and areas are read, too. VTK looks
  /// through all arrays for each one that is added, so ten thousand columns take a second. Default:
  /// on.
  vtkSetMacro(ReadAllColumns, bool);
  vtkGetMacro(ReadAllColumns, bool);
  vtkBooleanMacro(ReadAllColumns, bool);
  ///@}

  ///@{
  /// Whether GetRow() gives the text of each row, which then stays in memory. Default: off.
  vtkSetMacro(KeepRows, bool);
  vtkGetMacro(KeepRows, bool);
  vtkBooleanMacro(KeepRows, bool);
  ///@}

  /// The row of a point as it is in the file, without the end of its last line, after an update with
  /// KeepRows; empty otherwise.
  std::string GetRow(vtkIdType point) const;

  /// The first row of the file as it is, with the end of its last line, after an update; empty
  /// where nothing was read. Where the file ends with it, an end of line is added.
  std::string GetHeader() const;

  /// The names of all columns in their order, as the first row has them, after an update; none
  /// where nothing was read.
  vtkStringArray* GetColumnNames() { return this->ColumnNames; }

protected:
  vtkPointTableReader();
  ~vtkPointTableReader() override;

  vtkPointTableReader(const vtkPointTableReader&) = delete;
  void operator=(const vtkPointTableReader&) = delete;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  char* FileName = nullptr;
  bool ReadNormalsAndAreas = true;
  bool ReadAllColumns = true;
  bool KeepRows = false;

private:
  vtkNew<vtkStringArray> ColumnNames;
  std::unique_ptr<winding::PointTable> Table; ///< the header and the rows of the last file
};

#endif
