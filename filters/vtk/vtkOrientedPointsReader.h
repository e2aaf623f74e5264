/**
 * @class   vtkOrientedPointsReader
 * @brief   read points with normals from text (.xyz, .pwn)
 *
 * The reader gives vtkPolyData with points in double precision, the active point normals "Normals"
 * where the file has them, and one cell of all points, so that they can be seen.
 *
 * It reads one point on a line, as `x y z` or `x y z nx ny nz`, the same on all lines, and comments
 * from '#' on. The first line may be the number of points; the normals may then also stand in lines
 * of their own after all positions, as the classic .pwn has it: n, n lines of `x y z`, n lines of
 * `nx ny nz`. Normals are given as they are; they need not have unit length.
 *
 * Errors, each one line through vtkErrorMacro with the name and the line of the file, with the
 * error code set and the output empty: files that cannot be read, are empty, truncated or hold
 * anything else. NaN and infinite numbers are read as they are.
 *
 * @sa vtkGeomviewOFFReader vtkWindingNumberField vtkPCANormalEstimation
 */
#ifndef vtkOrientedPointsReader_h
#define vtkOrientedPointsReader_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSWINDING_EXPORT vtkOrientedPointsReader : public vtkPolyDataAlgorithm
{
public:
  static vtkOrientedPointsReader* New();
  vtkTypeMacro(vtkOrientedPointsReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The name of the file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkOrientedPointsReader();
  ~vtkOrientedPointsReader() override;

  vtkOrientedPointsReader(const vtkOrientedPointsReader&) = delete;
  void operator=(const vtkOrientedPointsReader&) = delete;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  char* FileName = nullptr;
};

#endif
