/**
 * @class   vtkGeomviewOFFReader
 * @brief   read Geomview's Object File Format (.off): vertices and polygons as text
 *
 * The reader gives vtkPolyData with points in double precision and polygons of any size. Faces with
 * two corners become lines, those with one become vertices; a file without faces gives one cell of
 * all its points.
 *
 * It reads the keyword OFF with the prefixes ST, C and N in this order, the counts on the same line
 * or the next, comments from '#' on, one vertex and one face on a line. Vertex normals (NOFF)
 * become the active point normals "Normals"; colours and texture coordinates are passed over. It
 * does not read binary files, nor the prefixes 4 and n (other dimensions).
 *
 * Errors, each one line through vtkErrorMacro with the name and the line of the file, with the
 * error code set and the output empty: files that cannot be read, are empty, truncated or not of
 * this format; counts that the file cannot hold, which are refused before anything is allocated;
 * indices of vertices that do not exist. NaN and infinite coordinates are read as they are.
 *
 * @sa vtkOrientedPointsReader vtkWindingNumberField
 */
#ifndef vtkGeomviewOFFReader_h
#define vtkGeomviewOFFReader_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSWINDING_EXPORT vtkGeomviewOFFReader : public vtkPolyDataAlgorithm
{
public:
  static vtkGeomviewOFFReader* New();
  vtkTypeMacro(vtkGeomviewOFFReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The name of the file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkGeomviewOFFReader();
  ~vtkGeomviewOFFReader() override;

  vtkGeomviewOFFReader(const vtkGeomviewOFFReader&) = delete;
  void operator=(const vtkGeomviewOFFReader&) = delete;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  char* FileName = nullptr;
};

#endif
