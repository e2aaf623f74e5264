// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWeakPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

/// Catches what a VTK object reports while the log lives, instead of letting it go to standard
/// error.
class ErrorLog
{
public:
  explicit ErrorLog(vtkObject* object);
  ~ErrorLog();
  ErrorLog(const ErrorLog&) = delete;
  void operator=(const ErrorLog&) = delete;

  /// All errors, or all warnings, one after the other; empty if there were none.
  const std::string& errors() const { return errors_; }
  const std::string& warnings() const { return warnings_; }

private:
  void observe(vtkObject* object, unsigned long event, std::string& log);

  std::string errors_, warnings_;
  std::vector<std::pair<vtkWeakPointer<vtkObject>, unsigned long>> observers_; ///< with their tags
};
