/**
 * @class   vtkSurfaceMeshReader
 * @brief   read surfaces and points from .obj, .ply and .stl, in full or not at all
 *
 * The reader gives vtkPolyData with the polygons of the file as they are, in the order of the file.
 * The suffix of the file's name, in small letters or capital ones, says which format it has.
 *
 * - Wavefront (.obj): vertices, faces, lines and points. Point normals "Normals" where there are as
 *   many as vertices and no corner names the normal of another vertex. Texture coordinates,
 *   colours, groups and materials are passed over.
 * - PLY (.ply), as text or in either order of bytes: vertices, and faces; at
 *   the vertices, where there are any, normals "Normals", colours of bytes "RGB" or "RGBA", and
 *   texture coordinates "TCoords" in single precision, as vtkPLYReader names them. Other elements
 *   and properties are passed over.
 * - STL (.stl), as text or binary: the triangles of all solids, each with three points of its own,
 *   in the order of the file. The filters of this module weld them; others may need
 *   vtkStaticCleanPolyData. The normals of facets and all attributes are passed over.
 *
 * Points are in double precision where the file holds more digits than single precision has: in all
 * text, and where PLY has numbers of type double or integers of four bytes. So are normals.
 *
 * The file is read by as many threads as vtkSMPTools has, and the result is the same for any number
 * of them. It takes little memory in addition to the output.
 *
 * Errors, each one line through vtkErrorMacro with the name of the file, and its line where it is
 * text, with the error code set and the output empty: files that cannot be read, are empty,
 * truncated or hold anything else; counts that the file cannot hold; corners that name what does
 * not exist.
 *
 * @sa vtkGeomviewOFFReader vtkOrientedPointsReader vtkWindingNumberField
 */
#ifndef vtkSurfaceMeshReader_h
#define vtkSurfaceMeshReader_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSWINDING_EXPORT vtkSurfaceMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceMeshReader* New();
  vtkTypeMacro(vtkSurfaceMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The name of the file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkSurfaceMeshReader();
  ~vtkSurfaceMeshReader() override;

  vtkSurfaceMeshReader(const vtkSurfaceMeshReader&) = delete;
  void operator=(const vtkSurfaceMeshReader&) = delete;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  char* FileName = nullptr;
};

#endif
