// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>

namespace winding
{

/**
 * Returns the seconds that work is expected to take. A run of an executor has done a part `done` of
 * its blocks, more than 0. `elapsed` is the time since the work began, `ofRun` the time of the
 * whole run by its pace, and `share` the executor's. Work before the run may have been slower than
 * its share of progress says, and the first blocks of a run slower than the others: the smaller
 * estimate counts.
 */
inline double expectedSeconds(
  double elapsed, double ofRun, double done, std::pair<double, double> share)
{
  const double length = share.second - share.first, progress = share.first + length * done;
  const double expected = elapsed + ofRun * (1 - done);
  return length > 0 ? std::max(expected,
                        std::min(elapsed / progress, elapsed + ofRun * (1 - progress) / length))
                    : expected;
}

} // namespace winding
