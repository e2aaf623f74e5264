#include "private/SourceMemory.h"

#include "private/FreeMemory.h"
#include "private/Ranks.h"
#include "private/SourceParts.h"

#include "vtkDataObject.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace winding
{

void refuseHugeSource(
  vtkDataObject* source, bool asPoints, const BytesOfWork& bytes, const char* what, Ranks& ranks)
{
  // A rank without a part of its own does not know what kind the others have.
  const bool isOwnMesh = source && !asPoints && kindOf(source) == SourceKind::mesh;
  const std::vector<Ranks::Number> meshes =
    ranks.exchange([isOwnMesh]() -> Ranks::Number { return isOwnMesh; });
  const bool isMesh =
    std::any_of(meshes.begin(), meshes.end(), [](Ranks::Number is) { return is != 0; });
  const std::vector<Ranks::Number> elements = ranks.exchange(
    [&]() -> Ranks::Number
    {
      return source
               ? source->GetNumberOfElements(isMesh ? vtkDataObject::CELL : vtkDataObject::POINT)
               : 0;
    });
  const Ranks::Number all = areEqual(elements)
                              ? elements[0]
                              : std::accumulate(elements.begin(), elements.end(), Ranks::Number{0});
  ranks.agree(
    [&]
    {
      refuseBeyondFreeMemory(static_cast<double>(all) * (isMesh ? bytes.perCell : bytes.perPoint),
        std::string(what) + " of " + std::to_string(all) + (isMesh ? " cells" : " points"),
        "take a part of the source, or fewer and larger triangles or points");
      return true;
    });
}

} // namespace winding
