// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Compares rows and caps with the direct sum, on as many random chains as there is time for.
// random_chains [cases] [first seed] [triangles] [tolerance]: prints the seeds of failures and a
// summary, and returns 1 if any case failed. By default there are 10000 cases of 12 triangles
// without a tolerance. With one, caps of more than a few triangles come from the far field.

#include "support/LatticeChain.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
  const long cases = argc > 1 ? std::atol(argv[1]) : 10000;
  const long firstSeed = argc > 2 ? std::atol(argv[2]) : 1;
  const int triangles = argc > 3 ? std::atoi(argv[3]) : 12;
  const double tolerance = argc > 4 ? std::atof(argv[4]) : 0;
  shapes::ChainComparison total;
  winding::SerialExecutor serial;
  long failures = 0, closed = 0;
  for (long i = 0; i < cases; ++i)
  {
    const auto seed = static_cast<unsigned>(firstSeed + i);
    const shapes::LatticeChain chain = shapes::randomLatticeChain(seed, triangles, 4);
    const shapes::ChainComparison found = shapes::compareWithDirectSum(chain, tolerance);
    closed += winding::boundaryChain(chain.surface, serial).edges.empty();
    total.offSurface += found.offSurface;
    total.onSurface += found.onSurface;
    total.onRim += found.onRim;
    total.means += found.means;
    total.largestError = std::max(total.largestError, found.largestError);
    if (!found.failure.empty())
    {
      ++failures;
      std::printf("seed %u: %s\n", seed, found.failure.c_str());
    }
  }
  std::printf(
    "%ld chains from seed %ld, %ld of them closed: %zu samples off the surface, largest "
    "error %.3g; %zu on it, %zu of those on the rim and %zu with the mean; %ld failures\n",
    cases, firstSeed, closed, total.offSurface, total.largestError, total.onSurface, total.onRim,
    total.means, failures);
  return failures > 0;
}
