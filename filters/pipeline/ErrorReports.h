// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

#include "vtkWindingABINamespace.h"

#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// The ways in which work that may throw ends; the numbers are the ones by which filters report
/// them (vtkWindingNumberAlgorithm::StatusType).
enum class Outcome
{
  done = 0,
  refused = 1,     ///< a Refusal was reported
  outOfMemory = 2, ///< OutOfMemory or a failed allocation was reported
  interrupted = 3
};

/**
 * Does work for a VTK object, and reports an exception as an error of this object, in one line. An
 * interruption is no error. `withoutMemory` tells of a failed allocation. Where
 * `isNew` is given, it is asked whether the error is to be reported.
 *
 * An algorithm answers the pipeline afterwards as if it had done its work, and leaves its output
 * empty. Where a request fails, the executive and filters behind add errors of their own, and
 * ParaView asks again with every picture.
 */
Outcome reportErrors(vtkObject* object, const Message& withoutMemory,
  const std::function<void()>& work, const std::function<bool()>& isNew = {});

} // namespace winding
