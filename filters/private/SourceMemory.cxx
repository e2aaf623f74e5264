#include "private/SourceMemory.h"

#include "private/FreeMemory.h"
#include "private/SourceParts.h"

#include "vtkDataObject.h"

namespace winding
{

void refuseHugeSource(
  vtkDataObject* source, bool asPoints, const BytesOfWork& bytes, const char* what)
{
  if (!source)
  {
    return;
  }
  const bool isMesh = !asPoints && kindOf(source) == SourceKind::mesh;
  const vtkIdType elements =
    source->GetNumberOfElements(isMesh ? vtkDataObject::CELL : vtkDataObject::POINT);
  refuseBeyondFreeMemory(static_cast<double>(elements) * (isMesh ? bytes.perCell : bytes.perPoint),
    std::string(what) + " of " + std::to_string(elements) + (isMesh ? " cells" : " points"),
    "take a part of the source, or fewer and larger triangles or points");
}

} // namespace winding
