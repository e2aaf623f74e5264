// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/Ranks.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "messages/Options.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/HostShare.h"
#include "tasks/Sentences.h"

#include "vtkMultiProcessController.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <iterator>
#include <new>
#include <string>

namespace winding
{

namespace
{

enum Status
{
  done,
  refused,
  outOfMemory,
  interrupted
};

/// The parts of the message that ranks give each other.
enum Part
{
  status,
  answer,
  host,
  parts
};

/// A number that distinguishes this machine from others of the program.
Ranks::Number hostNumber()
{
  static const Ranks::Number number = []
  {
    vtksys::SystemInformation system;
    system.RunOSCheck();
    return std::hash<std::string>()(system.GetHostname());
  }();
  return number;
}

[[noreturn]] void fail(Ranks::Number status, const std::string& text)
{
  if (status == interrupted)
  {
    throw Interrupted();
  }
  if (status == outOfMemory)
  {
    throw OutOfMemory(text);
  }
  throw Refusal(text);
}

} // namespace

bool areEqual(const std::vector<RankNumber>& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(),
    [&numbers](RankNumber number) { return number == numbers.front(); });
}

Ranks::Ranks(vtkMultiProcessController* controller, std::size_t mostNumbers)
  : controller_(controller)
  , mostNumbers_(mostNumbers)
{
}

int Ranks::rank() const
{
  return controller_ ? controller_->GetLocalProcessId() : 0;
}

int Ranks::count() const
{
  return controller_ ? controller_->GetNumberOfProcesses() : 1;
}

std::vector<Ranks::Number> Ranks::allGather(const std::function<Number()>& work)
{
  if (this->isAlone())
  {
    return {work()};
  }
  using Parts = std::array<Number, parts>;
  Parts own = {done, 0, hostNumber()};
  std::string text;
  try
  {
    own[answer] = work();
  }
  catch (const Interrupted&)
  {
    own[status] = interrupted;
  }
  catch (const OutOfMemory& refusal)
  {
    own[status] = outOfMemory;
    text = lineOf(refusal.message());
  }
  catch (const Refusal& refusal)
  {
    own[status] = refused;
    text = lineOf(refusal.message());
  }
  catch (const std::bad_alloc&)
  {
    own[status] = outOfMemory;
    text = "take fewer ranks on a machine, or a part of the source: there is not enough memory";
  }
  catch (const std::exception& error)
  {
    own[status] = refused;
    text = std::string("unexpected: ") + error.what();
  }
  if (hasFailed_)
  {
    fail(own[status], text); // the others know it from a call within this one
  }

  std::vector<Parts> all(static_cast<std::size_t>(this->count()));
  controller_->AllGather(own.data(), all.data()->data(), parts);
  setRanksOnHost(static_cast<int>(std::count_if(
    all.begin(), all.end(), [&own](const Parts& message) { return message[host] == own[host]; })));
  const auto failed = std::find_if(
    all.begin(), all.end(), [](const Parts& message) { return message[status] != done; });
  if (failed == all.end())
  {
    std::vector<Number> answers;
    std::transform(all.begin(), all.end(), std::back_inserter(answers),
      [](const Parts& message) { return message[answer]; });
    return answers;
  }
  hasFailed_ = true;
  const int first = static_cast<int>(failed - all.begin());
  text += " (rank " + std::to_string(first) + " of " + std::to_string(this->count()) + ")";
  int length = static_cast<int>(text.size());
  controller_->Broadcast(&length, 1, first);
  text.resize(static_cast<std::size_t>(length));
  controller_->Broadcast(text.data(), length, first);
  fail((*failed)[status], text);
}

void Ranks::barrier()
{
  this->agree([] {});
}

void Ranks::agree(const std::function<void()>& work)
{
  this->allOf(
    [&work]
    {
      work();
      return true;
    });
}

bool Ranks::allOf(const std::function<bool()>& work)
{
  const std::vector<Number> answers = this->allGather([&work]() -> Number { return work(); });
  return std::all_of(answers.begin(), answers.end(), [](Number answer) { return answer != 0; });
}

void Ranks::requireSame(const std::function<Number()>& hashOfProperties)
{
  if (!areEqual(this->allGather(hashOfProperties)))
  {
    throw Refusal(messageOf(Sentence::otherPropertiesOnRanks));
  }
}

template <class T> OfRanks<T> Ranks::gather(const std::vector<T>& own, bool onlyOnFirst)
{
  const auto ranks = static_cast<std::size_t>(this->count());
  OfRanks<T> result;
  result.starts.assign(1, 0);
  std::size_t most = 0;
  for (const Number numbers : this->allGather([&own] { return own.size(); }))
  {
    result.starts.push_back(result.starts.back() + numbers);
    most = std::max(most, static_cast<std::size_t>(numbers));
  }
  if (this->isAlone())
  {
    result.numbers = own;
    return result;
  }
  const bool isWanted = !onlyOnFirst || this->rank() == 0;
  const bool isOneRound = result.starts.back() <= mostNumbers_;
  const std::size_t perRank = isOneRound ? most : std::max<std::size_t>(1, mostNumbers_ / ranks);
  std::vector<T> round;
  this->agree(
    [&]
    {
      result.numbers.resize(isWanted ? result.starts.back() : 0);
      round.resize(isWanted && !isOneRound ? perRank * ranks : 0);
    });
  for (std::size_t done = 0; done < most; done += perRank)
  {
    const auto partOf = [&](std::size_t rank)
    {
      const std::size_t all = result.starts[rank + 1] - result.starts[rank];
      return std::min(perRank, all - std::min(all, done));
    };
    std::vector<vtkIdType> lengths, offsets;
    for (std::size_t rank = 0; rank < ranks; ++rank)
    {
      lengths.push_back(static_cast<vtkIdType>(partOf(rank)));
      offsets.push_back(static_cast<vtkIdType>(isOneRound ? result.starts[rank] : rank * perRank));
    }
    T* const to = isOneRound ? result.numbers.data() : round.data();
    const T* const from = own.data() + std::min(done, own.size());
    const vtkIdType length = lengths[static_cast<std::size_t>(this->rank())];
    if (onlyOnFirst)
    {
      controller_->GatherV(from, to, length, lengths.data(), offsets.data(), 0);
    }
    else
    {
      controller_->AllGatherV(from, to, length, lengths.data(), offsets.data());
    }
    for (std::size_t rank = 0; isWanted && !isOneRound && rank < ranks; ++rank)
    {
      std::copy_n(to + rank * perRank, partOf(rank),
        result.numbers.begin() + static_cast<std::ptrdiff_t>(result.starts[rank] + done));
    }
  }
  return result;
}

template OfRanks<double> Ranks::gather(const std::vector<double>&, bool);
template OfRanks<int> Ranks::gather(const std::vector<int>&, bool);
template OfRanks<vtkIdType> Ranks::gather(const std::vector<vtkIdType>&, bool);

} // namespace winding
