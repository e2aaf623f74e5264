#include "filters/ErrorLog.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

namespace
{

void append(vtkObject*, unsigned long, void* log, void* message)
{
  static_cast<std::string*>(log)->append(static_cast<const char*>(message));
}

void observe(vtkObject* object, unsigned long event, std::string& log)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(append);
  command->SetClientData(&log);
  object->AddObserver(event, command);
}

} // namespace

ErrorLog::ErrorLog(vtkObject* object)
{
  observe(object, vtkCommand::ErrorEvent, errors_);
  observe(object, vtkCommand::WarningEvent, warnings_);
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    // The executive adds a line of its own to every failure.
    static std::string executives;
    observe(algorithm->GetExecutive(), vtkCommand::ErrorEvent, executives);
  }
}
