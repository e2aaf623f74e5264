#include "private/output/MeshFiles.h"

#include "private/output/HandedArray.h"
#include "private/pipeline/ErrorReports.h"
#include "private/pipeline/SmpExecutor.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtksys/SystemTools.hxx"

namespace winding
{

namespace
{

vtkSmartPointer<vtkDataArray> handedOver(VectorArrays& vectors)
{
  if (vectors.doubles.empty() && !vectors.floats.empty())
  {
    return handedArray<vtkFloatArray>(vectors.floats, 3);
  }
  return handedArray<vtkDoubleArray>(vectors.doubles, 3);
}

vtkSmartPointer<vtkCellArray> handedOver(CellArrays& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  if (cells.count() > 0)
  {
    const auto offsets = handedArray<vtkTypeInt64Array>(cells.offsets, 1);
    array->SetData(offsets, handedArray<vtkTypeInt64Array>(cells.connectivity, 1));
  }
  return array;
}

unsigned long errorCodeOf(FileFault fault)
{
  switch (fault)
  {
  case FileFault::noName:
    return vtkErrorCode::NoFileNameError;
  case FileFault::notFound:
    return vtkErrorCode::FileNotFoundError;
  case FileFault::cannotOpen:
    return vtkErrorCode::CannotOpenFileError;
  case FileFault::ends:
    return vtkErrorCode::PrematureEndOfFileError;
  case FileFault::format:
    break;
  }
  return vtkErrorCode::FileFormatError;
}

} // namespace

void handOver(MeshArrays& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(handedOver(mesh.points));
  output->SetPoints(points);
  output->SetVerts(handedOver(mesh.vertices));
  output->SetLines(handedOver(mesh.lines));
  output->SetPolys(handedOver(mesh.polygons));
  if (mesh.normals.count() > 0)
  {
    const auto normals = handedOver(mesh.normals);
    normals->SetName("Normals");
    output->GetPointData()->SetNormals(normals);
  }
  if (!mesh.colors.empty())
  {
    const auto colors = handedArray<vtkUnsignedCharArray>(mesh.colors, mesh.colorComponents);
    colors->SetName(mesh.colorComponents == 4 ? "RGBA" : "RGB");
    output->GetPointData()->SetScalars(colors);
  }
  if (!mesh.textureCoordinates.empty())
  {
    const auto coordinates = handedArray<vtkFloatArray>(mesh.textureCoordinates, 2);
    coordinates->SetName("TCoords");
    output->GetPointData()->SetTCoords(coordinates);
  }
  if (!mesh.areas.empty())
  {
    const auto areas = handedArray<vtkDoubleArray>(mesh.areas, 1);
    areas->SetName("Area");
    output->GetPointData()->AddArray(areas);
  }
}

std::string suffixOf(const InputFile& file)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file.name()));
}

int readFile(vtkAlgorithm* reader, const char* fileName, unsigned long& errorCode,
  const FileParser& parse, vtkPolyData* output)
{
  errorCode = vtkErrorCode::NoError;
  const auto read = [&]()
  {
    try
    {
      const InputFile file(fileName);
      SmpExecutor executor(reader, 0);
      parse(file, executor);
    }
    catch (const FileRefusal& refusal)
    {
      errorCode = errorCodeOf(refusal.fault());
      throw;
    }
  };
  const std::string withoutMemory =
    std::string(fileName ? fileName : "") + ": there is not enough memory for what it holds";
  if (reportErrors(reader, withoutMemory, read) == Outcome::done)
  {
    return 1;
  }
  output->Initialize();
  return 0;
}

int readMeshFile(vtkAlgorithm* reader, const char* fileName, unsigned long& errorCode,
  const MeshParser& parse, vtkPolyData* output)
{
  const auto parseInto = [&](const InputFile& file, Executor& executor)
  {
    MeshArrays mesh = parse(file, executor);
    handOver(mesh, output);
  };
  return readFile(reader, fileName, errorCode, parseInto, output);
}

} // namespace winding
