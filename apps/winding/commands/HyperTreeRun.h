#pragma once

class Messages;
struct Options;

/// The commands field and voxels with an output .htg: makes the field as a hyper tree grid, in
/// which what is outside may be masked, and writes and reports it. Throws Failure for whatever
/// keeps it from being done.
void runHyperTree(const Options& options, bool masksOutside, Messages& messages);
