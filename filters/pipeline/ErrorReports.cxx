// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/ErrorReports.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "messages/Options.h"
#include "pipeline/FreeMemory.h"

#include "vtkErrorCode.h"
#include "vtkObject.h"

#include <cerrno>
#include <new>

namespace winding
{

unsigned long errorCodeOf(Outcome outcome)
{
  switch (outcome)
  {
  case Outcome::refused:
    return vtkErrorCode::UserError;
  case Outcome::outOfMemory:
    return ENOMEM;
  case Outcome::done:
  case Outcome::interrupted:
    break;
  }
  return vtkErrorCode::NoError;
}

Outcome reportErrors(vtkObject* object, int names, const Message& withoutMemory,
  const std::function<void()>& work, const std::function<bool()>& isNew)
{
  const bool isKnown = names >= 0 && names <= static_cast<int>(FrontEnd::python);
  const FrontEndScope scope(isKnown ? static_cast<FrontEnd>(names) : FrontEnd::cxx);
  const auto report = [object, &isNew](const std::string& text)
  {
    if (!isNew || isNew())
    {
      vtkErrorWithObjectMacro(object, << text);
    }
  };
  try
  {
    if (!isKnown)
    {
      throw Refusal("NamesInMessages is " + std::to_string(names) + "; it must be 0 to 3");
    }
    work();
    return Outcome::done;
  }
  catch (const Interrupted&)
  {
    return Outcome::interrupted;
  }
  catch (const OutOfMemory& refusal)
  {
    report(lineOf(refusal.message()));
    return Outcome::outOfMemory;
  }
  catch (const Refusal& refusal)
  {
    report(lineOf(refusal.message()));
    return Outcome::refused;
  }
  catch (const std::bad_alloc&)
  {
    report(lineOf(withoutMemory));
    return Outcome::outOfMemory;
  }
}

} // namespace winding
