#pragma once

class vtkDataObject;

namespace winding
{

class Ranks;

/// The memory that work on a source takes beside the source itself, in bytes.
struct BytesOfWork
{
  double perCell;  ///< of a mesh
  double perPoint; ///< of a cloud, or of a mesh that is taken as one
};

///@{
/// Measured with 1.28 million triangles and with 640 000 points: building a field, a report, and
/// areas.
constexpr BytesOfWork bytesOfField = {80, 250};
constexpr BytesOfWork bytesOfReport = {130, 330};
constexpr BytesOfWork bytesOfAreas = {250, 250};
///@}

/// Throws OutOfMemory where the work on a source that InputViews has looked at does not fit into
/// free memory, before anything is allocated. `what` names the work, as in "the report". The source
/// is that of all ranks together, unless they have equally much, as of copies. Collective.
void refuseHugeSource(
  vtkDataObject* source, bool asPoints, const BytesOfWork& bytes, const char* what, Ranks& ranks);

} // namespace winding
