// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * Keeps back the warnings of a VTK object while it does some work several times over. At its end
 * the object gives each once, with how many of the times it came at unless that is all of them.
 * Warnings that differ only by numbers are one, but names in quotation marks count.
 */
class DistinctWarnings
{
public:
  explicit DistinctWarnings(vtkObject* object);
  ~DistinctWarnings();
  DistinctWarnings(const DistinctWarnings&) = delete;
  DistinctWarnings& operator=(const DistinctWarnings&) = delete;

  /// Begins the next time.
  void begin() { ++times_; }

private:
  struct Kept
  {
    std::string text, kind;  ///< as it came first, and without numbers
    std::size_t times, last; ///< how often it came, and at which time last
  };

  static void keep(vtkObject* object, unsigned long event, void* warnings, void* text);

  vtkObject* object_;
  unsigned long observer_;
  std::size_t times_ = 0;
  std::vector<Kept> kept_;
};

} // namespace winding
