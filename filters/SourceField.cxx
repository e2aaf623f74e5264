#include "SourceField.h"

namespace winding
{

const Field& SourceField::prepare(vtkDataObject* source, const SourceOptions& options)
{
  InputViews views(source, options.input);
  wasBuilt_ = !field_ || views.identity() != identity_ || !(options_.input == options.input) ||
    !(options_.field == options.field);
  if (wasBuilt_)
  {
    field_ = nullptr; // the old and the new one need not fit into memory together
    field_ = views.isSurface() || views.identity().empty()
      ? Field::build(views.triangles(), options.field)
      : Field::build(views.orientedPoints(), options.field);
    identity_ = views.identity();
    options_ = options;
  }
  return *field_;
}

const Bounds& SourceField::bounds(vtkDataObject* source, const InputOptions& options)
{
  InputViews views(source, options);
  if (views.identity() != boundsIdentity_ || !(options == boundsOptions_))
  {
    bounds_ = views.isSurface() ? boundsOf(views.triangles()) : boundsOf(views.orientedPoints());
    boundsIdentity_ = views.identity();
    boundsOptions_ = options;
  }
  return bounds_;
}

const FieldInfo& SourceField::info() const
{
  static const FieldInfo none;
  return field_ ? field_->info() : none;
}

}
