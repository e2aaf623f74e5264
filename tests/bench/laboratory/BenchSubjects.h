// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/BenchTable.h"

#include <vector>

class Messages;
struct BenchOptions;

/**
 * @file
 * The subjects of the laboratory, each in a file of its own. Each measures one kind of thing and
 * gives its tables in the order in which they are printed.
 */
std::vector<BenchTable> benchKernels(const BenchOptions& options, Messages& messages);
std::vector<BenchTable> benchClouds(const BenchOptions& options, Messages& messages);
std::vector<BenchTable> benchVtk(const BenchOptions& options, Messages& messages);
std::vector<BenchTable> benchOrientation(const BenchOptions& options, Messages& messages);
std::vector<BenchTable> benchHierarchical(const BenchOptions& options, Messages& messages);

/// The values of an option where the command line gave some, or else the usual ones of a subject.
template <class Value>
std::vector<Value> givenOr(const std::vector<Value>& given, const std::vector<Value>& usual)
{
  return given.empty() ? usual : given;
}
