// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Limits vtkSMPTools to `threads` threads, as far as the machine has them; 0 changes nothing.
void limitThreads(int threads);

/// How many threads filters use after limitThreads() of the same number.
int threadsUsed(int threads);
