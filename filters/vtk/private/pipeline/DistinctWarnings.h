// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Keeps back the warnings of a VTK object while it lives. At its end the object gives those that
/// differ by more than numbers.
class DistinctWarnings
{
public:
  explicit DistinctWarnings(vtkObject* object);
  ~DistinctWarnings();
  DistinctWarnings(const DistinctWarnings&) = delete;
  DistinctWarnings& operator=(const DistinctWarnings&) = delete;

private:
  static void keep(vtkObject* object, unsigned long event, void* warnings, void* text);

  vtkObject* object_;
  unsigned long observer_;
  std::vector<std::string> kept_;
};

} // namespace winding
