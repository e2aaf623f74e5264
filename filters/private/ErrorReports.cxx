#include "private/ErrorReports.h"

#include "base/Executor.h"
#include "private/FreeMemory.h"

#include "vtkObject.h"

#include <new>

namespace winding
{

Outcome reportErrors(
  vtkObject* object, const std::string& withoutMemory, const std::function<void()>& work)
{
  try
  {
    work();
    return Outcome::done;
  }
  catch (const Interrupted&)
  {
    return Outcome::interrupted;
  }
  catch (const OutOfMemory& refusal)
  {
    vtkErrorWithObjectMacro(object, << refusal.what());
    return Outcome::outOfMemory;
  }
  catch (const Refusal& refusal)
  {
    vtkErrorWithObjectMacro(object, << refusal.what());
    return Outcome::refused;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(object, << withoutMemory);
    return Outcome::outOfMemory;
  }
}

} // namespace winding
