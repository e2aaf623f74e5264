// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/pipeline/DistinctWarnings.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <algorithm>
#include <limits>

namespace winding
{

namespace
{

/// Returns a warning without what vtkWarningMacro() adds.
std::string messageOf(const std::string& text)
{
  const std::string address = "): ";
  const std::size_t place = text.find(address);
  const std::string message =
    place == std::string::npos ? text : text.substr(place + address.size());
  return message.substr(0, message.find_last_not_of('\n') + 1);
}

std::string withoutDigits(std::string text)
{
  text.erase(std::remove_if(text.begin(), text.end(),
               [](char letter) { return letter >= '0' && letter <= '9'; }),
    text.end());
  return text;
}

} // namespace

DistinctWarnings::DistinctWarnings(vtkObject* object)
  : object_(object)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(&DistinctWarnings::keep);
  command->SetClientData(this);
  command->SetAbortFlagOnExecute(1); // other observers hear nothing meanwhile
  observer_ =
    object->AddObserver(vtkCommand::WarningEvent, command, std::numeric_limits<float>::max());
}

DistinctWarnings::~DistinctWarnings()
{
  object_->RemoveObserver(observer_);
  for (const std::string& message : kept_)
  {
    vtkWarningWithObjectMacro(object_, << message);
  }
}

void DistinctWarnings::keep(vtkObject*, unsigned long, void* warnings, void* text)
{
  std::vector<std::string>& kept = static_cast<DistinctWarnings*>(warnings)->kept_;
  const std::string message = messageOf(static_cast<const char*>(text));
  const bool isKnown = std::any_of(kept.begin(), kept.end(),
    [&message](const std::string& known)
    { return withoutDigits(known) == withoutDigits(message); });
  if (!isKnown)
  {
    kept.push_back(message);
  }
}

} // namespace winding
