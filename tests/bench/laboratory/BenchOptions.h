// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/// All that the command line of the laboratory can say. An empty list stands for the values that
/// suit the subject.
struct BenchOptions
{
  std::string subject;
  std::vector<std::string> files;
  std::vector<int> resolutions;
  std::vector<double> tolerances; ///< of the far fields of "hierarchical"
  std::vector<int> points;        ///< numbers of scattered points
  std::vector<int> sources;       ///< numbers of triangles and points of the spheres
  int threads = 0;
  bool json = false;
};
