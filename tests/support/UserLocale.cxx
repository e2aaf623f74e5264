// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// The user's locale for programs of tests, as Qt chooses it for its hosts.

#include <clocale>
#include <cstdio>
#include <cstdlib>

namespace
{

[[maybe_unused]] const bool isTaken = []
{
  const bool isThere = std::setlocale(LC_ALL, "") != nullptr;
  if (!isThere && std::getenv("LOCPATH"))
  {
    std::fputs("the locale that LC_ALL names is not in LOCPATH\n", stderr);
    std::exit(EXIT_FAILURE);
  }
  return isThere;
}();

} // namespace
