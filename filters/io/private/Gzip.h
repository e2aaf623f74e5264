// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/InputFile.h"
#include "files/PlainArray.h"

namespace winding
{

class Executor;

/// Unpacks a file that was packed by gzip, in one part or several. Throws FileRefusal where it is
/// none, or damaged, OutOfMemory before anything is allocated that is not free, and Interrupted.
PlainArray<char> unpackGzip(const InputFile& packed, Executor& executor);

} // namespace winding
