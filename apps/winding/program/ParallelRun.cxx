// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/ParallelRun.h"

#include "program/Interrupt.h"
#include "program/Messages.h"

#include "vtkMultiProcessController.h"
#ifdef WINDING_MPI
#include "vtkMPIController.h"
#endif

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <new>
#include <numeric>
#include <string>

#include <unistd.h>

namespace parallel
{

namespace
{

vtkMultiProcessController* controller = nullptr; ///< null for a single rank
int ranksOnHost = 1;

/// A number that the launcher sets in its programs' environment; -1 where it does not.
int numberFromLauncher(std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    if (const char* text = std::getenv(name))
    {
      return std::atoi(text);
    }
  }
  return -1;
}

/// Whether the program is one of several that a launcher of MPI has started. PMIx gives no size.
bool isOneOfSeveral()
{
  const int size = numberFromLauncher({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"});
  return size > 1 || (size < 0 && numberFromLauncher({"PMIX_RANK"}) >= 0);
}

double hostNumber()
{
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return static_cast<double>(std::hash<std::string>()(name) >> 12); // a double holds 52 bits
}

struct Outcome
{
  int status = EXIT_DONE;
  std::string line;
};

Outcome outcomeOf(const std::function<void()>& work)
{
  try
  {
    work();
    interrupt::check();
    return {};
  }
  catch (const AgreedFailure&)
  {
    throw;
  }
  catch (const Failure& failure)
  {
    return {failure.status, failure.what()};
  }
  catch (const std::bad_alloc&)
  {
    return {EXIT_NO_MEMORY, outOfMemoryAdvice()};
  }
  catch (const std::exception& error)
  {
    return {EXIT_REFUSED, std::string("unexpected: ") + error.what()};
  }
}

/// The messages of MPI are counted by ints.
template <class Transfer> void inRounds(std::size_t bytes, const Transfer& transfer)
{
  constexpr std::size_t most = std::size_t(1) << 30;
  for (std::size_t done = 0; done < bytes; done += most)
  {
    transfer(done, static_cast<vtkIdType>(std::min(most, bytes - done)));
  }
}

constexpr int tag = 1603;

} // namespace

void start(int& argc, char**& argv)
{
  if (!isOneOfSeveral())
  {
    return;
  }
#ifdef WINDING_MPI
  vtkMPIController* const mpi = vtkMPIController::New();
  mpi->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(mpi);
  if (mpi->GetNumberOfProcesses() > 1)
  {
    controller = mpi;
    const double own = hostNumber();
    const std::vector<double> hosts = allGather(own);
    ranksOnHost = static_cast<int>(std::count(hosts.begin(), hosts.end(), own));
    interrupt::joinRanks(isFirst());
  }
#else
  static_cast<void>(argc);
  static_cast<void>(argv);
  if (numberFromLauncher({"OMPI_COMM_WORLD_RANK", "PMI_RANK", "MV2_COMM_WORLD_RANK", "PMIX_RANK"}) >
      0)
  {
    _exit(EXIT_USAGE);
  }
  throw Failure(EXIT_USAGE, "start it without mpirun: this program was built without MPI");
#endif
}

void finish()
{
#ifdef WINDING_MPI
  if (auto* const mpi =
        vtkMPIController::SafeDownCast(vtkMultiProcessController::GetGlobalController()))
  {
    vtkMultiProcessController::SetGlobalController(nullptr);
    controller = nullptr;
    mpi->Finalize();
    mpi->Delete();
  }
#endif
}

int count()
{
  return controller ? controller->GetNumberOfProcesses() : 1;
}

int rank()
{
  return controller ? controller->GetLocalProcessId() : 0;
}

bool isFirst()
{
  return rank() == 0;
}

bool isAlone()
{
  return !controller;
}

int countOnHost()
{
  return ranksOnHost;
}

void agree(const std::function<void()>& work)
{
  if (isAlone())
  {
    work();
    return;
  }
  const Outcome own = outcomeOf(work);
  const std::vector<double> statuses = allGather(own.status);
  const auto failed = std::find_if(
    statuses.begin(), statuses.end(), [](double status) { return status != EXIT_DONE; });
  if (failed == statuses.end())
  {
    return;
  }
  const auto first = static_cast<int>(failed - statuses.begin());
  std::string line = own.line;
  auto length = static_cast<int>(line.size());
  controller->Broadcast(&length, 1, first);
  line.resize(static_cast<std::size_t>(length));
  controller->Broadcast(line.data(), length, first);
  throw AgreedFailure(static_cast<ExitStatus>(static_cast<int>(*failed)), line);
}

void agreeOnFirst(const std::function<void()>& work)
{
  agree(
    [&work]
    {
      if (isFirst())
      {
        work();
      }
    });
}

void barrier()
{
  if (controller)
  {
    controller->Barrier();
  }
}

std::vector<double> allGather(double own)
{
  std::vector<double> all(static_cast<std::size_t>(count()), own);
  if (controller)
  {
    controller->AllGather(&own, all.data(), 1);
  }
  return all;
}

double maximum(double own)
{
  const std::vector<double> all = allGather(own);
  return *std::max_element(all.begin(), all.end());
}

double sum(double own)
{
  const std::vector<double> all = allGather(own);
  return std::accumulate(all.begin(), all.end(), 0.0);
}

void send(const void* from, std::size_t bytes, int toRank)
{
  const auto* const data = static_cast<const unsigned char*>(from);
  inRounds(bytes, [&](std::size_t done, vtkIdType length)
    { controller->Send(data + done, length, toRank, tag); });
}

void receive(void* to, std::size_t bytes, int fromRank)
{
  auto* const data = static_cast<unsigned char*>(to);
  inRounds(bytes, [&](std::size_t done, vtkIdType length)
    { controller->Receive(data + done, length, fromRank, tag); });
}

} // namespace parallel
