// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

namespace shapes
{

/// Runs work on the calling thread. It has no state, so that all tests share one.
inline winding::SerialExecutor serial;

} // namespace shapes
