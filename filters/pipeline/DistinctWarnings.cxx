// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/DistinctWarnings.h"

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

/// Returns a warning without what vtkWarningMacro() adds: a line with the place, then the class,
/// the address, and the name of the object if it has one.
std::string messageOf(const std::string& text)
{
  const std::size_t line = text.find('\n');
  const std::string second = line == std::string::npos ? text : text.substr(line + 1);
  const std::size_t colon = second.find(": ");
  const std::string message = colon == std::string::npos ? second : second.substr(colon + 2);
  return message.substr(0, message.find_last_not_of('\n') + 1);
}

/// Returns a text without digits, except between quotation marks.
std::string withoutNumbers(const std::string& text)
{
  std::string kind;
  bool isName = false;
  for (const char letter : text)
  {
    isName = isName != (letter == '\'');
    if (isName || letter < '0' || letter > '9')
    {
      kind += letter;
    }
  }
  return kind;
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
  for (const Kept& kept : kept_)
  {
    const std::string often = kept.times == times_
                                ? ""
                                : (kept.text.find("; ") == std::string::npos ? "; " : ", ") +
                                    std::string("at ") + std::to_string(kept.times) + " of " +
                                    std::to_string(times_) + " times";
    vtkWarningWithObjectMacro(object_, << kept.text << often);
  }
}

void DistinctWarnings::keep(vtkObject*, unsigned long, void* warnings, void* text)
{
  auto& own = *static_cast<DistinctWarnings*>(warnings);
  const std::string message = messageOf(static_cast<const char*>(text));
  const std::string kind = withoutNumbers(message);
  const auto known = std::find_if(
    own.kept_.begin(), own.kept_.end(), [&kind](const Kept& kept) { return kept.kind == kind; });
  if (known == own.kept_.end())
  {
    own.kept_.push_back({message, kind, 1, own.times_});
  }
  else if (known->last != own.times_)
  {
    ++known->times;
    known->last = own.times_;
  }
}

} // namespace winding
