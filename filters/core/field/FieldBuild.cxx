#include "base/Executor.h"
#include "base/Views.h"
#include "field/CloudField.h"
#include "field/SurfaceField.h"

namespace winding
{

namespace
{

template <class FieldType, class Views>
std::shared_ptr<const Field> buildUnlessInterrupted(
  const Views& views, const FieldOptions& options, Executor& executor)
{
  try
  {
    return std::make_shared<FieldType>(views, options, executor);
  }
  catch (const Interrupted&)
  {
    return nullptr;
  }
}

} // namespace

std::shared_ptr<const Field> Field::build(
  const std::vector<TrianglesView>& views, const FieldOptions& options, Executor& executor)
{
  return buildUnlessInterrupted<SurfaceField>(views, options, executor);
}

std::shared_ptr<const Field> Field::build(
  const std::vector<OrientedPointsView>& views, const FieldOptions& options, Executor& executor)
{
  return buildUnlessInterrupted<CloudField>(views, options, executor);
}

} // namespace winding
