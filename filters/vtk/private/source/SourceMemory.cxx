// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/SourceMemory.h"

#include "pipeline/FreeMemory.h"
#include "pipeline/Ranks.h"
#include "private/source/InputViews.h"

#include <numeric>
#include <string>
#include <vector>

namespace winding
{

void refuseHugeSource(const InputViews& source, const BytesOfWork& bytes, const char* what,
  Ranks& ranks, bool onlyOnFirst)
{
  const bool isMesh = source.isSurface();
  const std::vector<Ranks::Number> elements =
    ranks.allGather([&source]() -> Ranks::Number { return source.ownElements(); });
  const Ranks::Number all = source.areCopies()
                              ? elements.front()
                              : std::accumulate(elements.begin(), elements.end(), Ranks::Number{0});
  ranks.agree(
    [&]
    {
      if (!onlyOnFirst || ranks.rank() == 0)
      {
        refuseBeyondFreeMemory(static_cast<double>(all) * (isMesh ? bytes.perCell : bytes.perPoint),
          std::string(what) + " of " + std::to_string(all) + (isMesh ? " cells" : " points"),
          {{"take a part of the source", {}}, {"take fewer and larger triangles or points", {}}});
      }
    });
}

} // namespace winding
