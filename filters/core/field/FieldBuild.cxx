#include "base/Executor.h"
#include "base/Views.h"
#include "field/CloudField.h"
#include "field/SurfaceField.h"

namespace winding
{

std::shared_ptr<const Field> Field::build(
  const std::vector<TrianglesView>& views, const FieldOptions& options, Executor& executor)
{
  return std::make_shared<SurfaceField>(views, options, executor);
}

std::shared_ptr<const Field> Field::build(
  const std::vector<OrientedPointsView>& views, const FieldOptions& options, Executor& executor)
{
  return std::make_shared<CloudField>(views, options, executor);
}

} // namespace winding
