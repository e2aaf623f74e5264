#pragma once

#include <string>
#include <vector>

struct Options;

/// The files that no output may replace: those that are read, or none with --overwrite.
std::vector<std::string> filesToKeep(const Options& options);
