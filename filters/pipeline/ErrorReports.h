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

/// Returns the ErrorCode of algorithms that end so: UserError where work was refused, the system's
/// ENOMEM where memory ran out. An interruption is no error.
unsigned long errorCodeOf(Outcome outcome);

/**
 * Does work for a VTK object, and reports an exception as an error of this object, in one line. An
 * interruption is no error. `withoutMemory` tells of a failed allocation. Where
 * `isNew` is given, it is asked whether the error is to be reported. All messages meanwhile are in
 * the words of `names`, a vtkWindingNumberAlgorithm::NamesInMessagesType.
 *
 * An algorithm answers the pipeline afterwards as if it had done its work, sets its ErrorCode and
 * leaves its output empty: the executive prints 14 lines for each request that fails, and again for
 * each filter behind.
 */
Outcome reportErrors(vtkObject* object, int names, const Message& withoutMemory,
  const std::function<void()>& work, const std::function<bool()>& isNew = {});

} // namespace winding
