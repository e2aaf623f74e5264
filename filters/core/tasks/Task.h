// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Memory.h"
#include "base/Message.h"

#include <functional>

/**
 * @file
 * A task makes one product of fields: it decides, evaluates and warns. The front ends that call it
 * convert their options, give it memory for results (Sink.h), and show its messages.
 */
namespace winding
{

/// The executor, warnings and memory that a front end gives to each run of a task.
struct Run
{
  Executor& executor;
  std::function<void(const Message&)> warn; ///< shows a warning
  FreeMemory freeMemory;                    ///< what the task may take; null for any amount
};

} // namespace winding
