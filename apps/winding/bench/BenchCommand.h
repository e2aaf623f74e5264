#pragma once

class Messages;
struct Options;

/// The command bench: measures its subject and prints the tables. Throws Failure for whatever keeps
/// it from being done.
void runBench(const Options& options, Messages& messages);
