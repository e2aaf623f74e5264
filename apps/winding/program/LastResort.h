// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Lets an exception that nobody can catch (memory that runs out in a destructor, or while an error
/// is being reported) end the program in one line and with a status of ours, too.
void installLastResort();

/// Says on standard error that memory has run out, and leaves without unwinding. Asks for no
/// memory.
[[noreturn]] void leaveWithoutMemory();
