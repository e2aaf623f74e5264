// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace winding
{

/// The processes of an MPI program on this machine that work together, this one among them: they
/// share its cores and its memory. 1 until Ranks has met others.
int ranksOnHost();

/// Sets the number; Ranks calls it, and the module of readers, which has a copy of its own.
void setRanksOnHost(int ranks);

} // namespace winding
