#include "private/ErrorReports.h"

#include "base/Executor.h"
#include "private/FreeMemory.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <cstring>
#include <new>

namespace winding
{

namespace
{

/// Takes the line of an executive that says no more than that its algorithm failed, once. All other
/// errors go where they would go without it.
class FailureNote : public vtkCommand
{
public:
  static FailureNote* New() { return new FailureNote; }

  void Execute(vtkObject* executive, unsigned long, void* data) override
  {
    executive->RemoveObserver(this);
    const char* text = static_cast<const char*>(data);
    if (text && !std::strstr(text, "returned failure for request"))
    {
      vtkOutputWindowDisplayErrorText(text);
    }
  }
};

/// An algorithm that fails has said why; a second error about it tells the user nothing.
void takeFailureNote(vtkObject* object)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(object);
  vtkExecutive* executive = algorithm ? algorithm->GetExecutive() : nullptr;
  if (executive && !executive->HasObserver(vtkCommand::ErrorEvent))
  {
    const auto note = vtkSmartPointer<FailureNote>::New();
    executive->AddObserver(vtkCommand::ErrorEvent, note);
  }
}

} // namespace

Outcome reportErrors(
  vtkObject* object, const std::string& withoutMemory, const std::function<void()>& work)
{
  const auto report = [object](const std::string& text)
  {
    vtkErrorWithObjectMacro(object, << text);
    takeFailureNote(object);
  };
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
    report(refusal.what());
    return Outcome::outOfMemory;
  }
  catch (const Refusal& refusal)
  {
    report(refusal.what());
    return Outcome::refused;
  }
  catch (const std::bad_alloc&)
  {
    report(withoutMemory);
    return Outcome::outOfMemory;
  }
}

} // namespace winding
