// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/HostShare.h"

#include <atomic>

namespace winding
{

namespace
{

std::atomic<int> ranks{1};

} // namespace

int ranksOnHost()
{
  return ranks;
}

void setRanksOnHost(int number)
{
  ranks = number;
}

} // namespace winding
