#include "private/SourceField.h"

#include "private/SourceMemory.h"
#include "source/Sanitize.h"

namespace winding
{

bool SourceField::Memory::isSame(const InputViews& views, const InputOptions& options)
{
  const bool sameOptions = options == options_;
  if (sameOptions && views.identity() == identity_)
  {
    return true;
  }
  const std::uint64_t fingerprint = views.fingerprint();
  const bool same = sameOptions && !identity_.empty() && fingerprint == fingerprint_;
  identity_ = views.identity();
  options_ = options;
  fingerprint_ = fingerprint;
  return same;
}

const Field* SourceField::prepare(
  vtkDataObject* source, const SourceOptions& options, Executor& executor)
{
  InputViews views(source, options.input);
  const bool isSameSource = source_.isSame(views, options.input);
  wasBuilt_ = !field_ || !isSameSource || !(options_ == options.field);
  if (wasBuilt_)
  {
    field_ = nullptr; // the old and the new one need not fit into memory together
    refuseHugeSource(source, options.input.asPoints, bytesOfField, "the field");
    field_ = views.isSurface() || views.identity().empty()
               ? Field::build(views.triangles(), options.field, executor)
               : Field::build(views.orientedPoints(), options.field, executor);
    options_ = options.field;
  }
  return field_.get();
}

const Bounds& SourceField::bounds(vtkDataObject* source, const InputOptions& options)
{
  InputViews views(source, options);
  Memory memory = boundedSource_;
  if (!memory.isSame(views, options))
  {
    bounds_ = views.isSurface() ? boundsOf(views.triangles()) : boundsOf(views.orientedPoints());
  }
  boundedSource_ = memory; // not before: a source that is refused must be refused again
  return bounds_;
}

const FieldInfo& SourceField::info() const
{
  static const FieldInfo none;
  return field_ ? field_->info() : none;
}

} // namespace winding
