// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"

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

} // namespace

void ErrorLog::observe(vtkObject* object, unsigned long event, std::string& log)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(append);
  command->SetClientData(&log);
  observers_.emplace_back(object, object->AddObserver(event, command));
}

ErrorLog::ErrorLog(vtkObject* object)
{
  this->observe(object, vtkCommand::ErrorEvent, errors_);
  this->observe(object, vtkCommand::WarningEvent, warnings_);
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    // The executive adds a line of its own to every failure.
    static std::string executives;
    this->observe(algorithm->GetExecutive(), vtkCommand::ErrorEvent, executives);
  }
}

ErrorLog::~ErrorLog()
{
  for (const auto& [object, tag] : observers_)
  {
    if (object)
    {
      object->RemoveObserver(tag);
    }
  }
}
