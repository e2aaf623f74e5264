#pragma once

struct BenchOptions;

/// Throws Failure(USAGE) for options of bench that make no sense, alone or together.
void checkBenchOptions(const BenchOptions& options);
