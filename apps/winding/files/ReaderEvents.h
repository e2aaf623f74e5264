// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCommand.h"

/// Sent by a reader with the bytes (double) that it takes as long to read as, in addition to the
/// file's own.
constexpr unsigned long moreBytesEvent = vtkCommand::UserEvent + 1;
