// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"

#include "support/Dual.h"
#include "support/Serial.h"

#include <sstream>

namespace fuzz
{

std::string checkLattice(Choices& choices)
{
  // A case is worth as much time as one of the other checks.
  constexpr int solids = 8;
  shapes::Random random(static_cast<unsigned>(choices.below(1 << 30)));
  for (int n = 0; n < solids; ++n)
  {
    const shapes::LatticeCase lattice(random);
    const shapes::Dual dual(lattice.field, lattice.grid, shapes::serial);
    for (const std::uint64_t cuts : {std::uint64_t(0), random.bits() | 1})
    {
      const shapes::ManifoldFaults faults = shapes::manifoldFaults(dual.polygons(cuts));
      if (faults.any())
      {
        std::ostringstream text;
        text << "the dual mesh of the bits " << lattice.bits << " on "
             << lattice.grid.dimensions.transpose() << " samples, cut by " << cuts << ", has "
             << faults.edges << " faulty edges and " << faults.fans << " faulty fans";
        return text.str();
      }
    }
  }
  return "";
}

} // namespace fuzz
