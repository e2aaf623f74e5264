#pragma once

#include "BenchTable.h"

class Messages;
struct Options;

/**
 * @file
 * The kinds of measurement that bench does. Each gives tables, one after the other.
 */
std::vector<BenchTable> benchFiles(const Options& options, Messages& messages);
std::vector<BenchTable> benchSeed(const Options& options, Messages& messages);
std::vector<BenchTable> benchKernels(const Options& options);
std::vector<BenchTable> benchClouds(const Options& options, Messages& messages);
std::vector<BenchTable> benchVtk(const Options& options, Messages& messages);
std::vector<BenchTable> benchHierarchical(const Options& options, Messages& messages);
