#pragma once

#include <functional>
#include <string>

class vtkObject;

namespace winding
{

/// The ways in which work that may throw ends.
enum class Outcome
{
  done,
  interrupted,
  refused,    ///< a Refusal was reported
  outOfMemory ///< OutOfMemory or a failed allocation was reported
};

/**
 * Does work for a VTK object, and reports an exception as an error of this object, in one line: an
 * algorithm's executive adds none of its own, unless somebody observes its errors.
 * An interruption is no error. `withoutMemory` is the line that tells of a failed allocation.
 */
Outcome reportErrors(
  vtkObject* object, const std::string& withoutMemory, const std::function<void()>& work);

} // namespace winding
