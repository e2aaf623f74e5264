// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class Messages;
struct Options;

/**
 * @file
 * The commands of the program, each in a file of its own. They throw Failure for whatever keeps
 * them from being done.
 */
void runField(const Options& options, Messages& messages);
void runSurface(const Options& options, Messages& messages);
void runBoolean(const Options& options, Messages& messages);
void runVoxels(const Options& options, Messages& messages);
void runLabels(const Options& options, Messages& messages);
void runProbe(const Options& options, Messages& messages);
void runNormals(const Options& options, Messages& messages);
void runCheck(const Options& options, Messages& messages);
void runBench(const Options& options, Messages& messages);
