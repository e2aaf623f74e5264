#pragma once

#include <memory>

class OutputFile;
struct Options;

/// The output file on the first rank, null on the others. Throws Failure on all ranks where it
/// cannot be written. Collective.
std::unique_ptr<OutputFile> openOnFirstRank(const Options& options);
