// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Tries every check of the core on random cases, one case for each seed.
// differential [cases] [first seed] [threads] [check]: prints the seeds of failures and a summary,
// and returns 1 if any case failed. By default there are 1000 cases of all checks together, on all
// threads. A check alone gets all of the cases; the checks "time", "soup_time" and "growth" run
// only so, and report the worst time.

#include "Checks.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <thread>

namespace
{

using Clock = std::chrono::steady_clock;

struct Totals
{
  std::atomic<long> next{0}, failures{0};
  std::atomic<long> slowestMilliseconds{0}, slowestSeed{0};
};

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void runCase(const fuzz::NamedCheck& named, std::uint64_t seed, Totals& totals)
{
  const auto start = Clock::now();
  std::string failure;
  try
  {
    fuzz::Choices choices(seed);
    failure = named.check(choices);
  }
  catch (const std::exception& error)
  {
    failure = std::string("throws ") + error.what();
  }
  if (!failure.empty())
  {
    ++totals.failures;
    std::printf(
      "%s, seed %lu: %s\n", named.name, static_cast<unsigned long>(seed), failure.c_str());
    std::fflush(stdout);
  }
  const long milliseconds = static_cast<long>(1000 * secondsSince(start));
  if (milliseconds > totals.slowestMilliseconds)
  {
    totals.slowestMilliseconds = milliseconds;
    totals.slowestSeed = static_cast<long>(seed);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const long cases = argc > 1 ? std::atol(argv[1]) : 1000;
  const long firstSeed = argc > 2 ? std::atol(argv[2]) : 0;
  const long threads = argc > 3 ? std::atol(argv[3]) : 0;
  const std::string only = argc > 4 ? argv[4] : "";
  std::vector<fuzz::NamedCheck> checks;
  if (only == "time")
  {
    checks = {{"time", fuzz::checkTime}, {"soup_time", fuzz::checkSoupTime},
      {"growth", fuzz::checkGrowth}, {"diagnosis_time", fuzz::checkDiagnosisTime}};
  }
  else if (only == "growth")
  {
    checks = {{"growth", fuzz::checkGrowth}};
  }
  else if (only == "soup_time")
  {
    checks = {{"soup_time", fuzz::checkSoupTime}};
  }
  const bool isTimed = !checks.empty();
  for (const fuzz::NamedCheck& check : fuzz::allChecks())
  {
    if (only.empty() || only == check.name)
    {
      checks.push_back(check);
    }
  }
  if (checks.empty())
  {
    std::fprintf(stderr, "there is no check %s\n", only.c_str());
    return 2;
  }

  const auto start = Clock::now();
  Totals totals;
  std::vector<std::thread> workers;
  const long most = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  for (long i = 0; i < most; ++i)
  {
    workers.emplace_back(
      [&]
      {
        for (long n = totals.next++; n < cases; n = totals.next++)
        {
          const auto seed = static_cast<std::uint64_t>(firstSeed + n);
          runCase(checks[seed % checks.size()], seed, totals);
        }
      });
  }
  for (std::thread& worker : workers)
  {
    worker.join();
  }
  std::printf(
    "%ld cases from seed %ld on %ld threads in %.1f s: %ld failures; the slowest, seed %ld, "
    "took %ld ms\n",
    cases, firstSeed, most, secondsSince(start), totals.failures.load(), totals.slowestSeed.load(),
    totals.slowestMilliseconds.load());
  if (isTimed)
  {
    std::printf("%s\n", fuzz::worstTime().c_str());
  }
  return totals.failures > 0;
}
