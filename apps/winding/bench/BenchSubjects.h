#pragma once

#include "bench/BenchTable.h"

#include <vector>

class Messages;
struct Options;

/**
 * @file
 * The subjects of bench, each in a file of its own. Each measures one kind of thing and gives its
 * tables in the order in which they are printed.
 */
std::vector<BenchTable> benchFiles(const Options& options, Messages& messages);
std::vector<BenchTable> benchSeed(const Options& options, Messages& messages);
std::vector<BenchTable> benchKernels(const Options& options, Messages& messages);
std::vector<BenchTable> benchClouds(const Options& options, Messages& messages);
std::vector<BenchTable> benchExpected(const Options& options, Messages& messages);
std::vector<BenchTable> benchVtk(const Options& options, Messages& messages);
std::vector<BenchTable> benchOrientation(const Options& options, Messages& messages);
std::vector<BenchTable> benchHierarchical(const Options& options, Messages& messages);

/// The values of an option where the command line gave some, or else the usual ones of a subject.
template <class Value>
std::vector<Value> givenOr(const std::vector<Value>& given, const std::vector<Value>& usual)
{
  return given.empty() ? usual : given;
}
