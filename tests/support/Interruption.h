// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "support/Serial.h"

namespace shapes
{

/// An executor that is interrupted after a number of whole runs and of blocks of the next, and in
/// all runs after that.
class Interruption final : public winding::Executor
{
public:
  explicit Interruption(int runs, std::size_t blocks = 0)
    : runs_(runs)
    , blocks_(blocks)
  {
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    cameToPass_ = cameToPass_ || runs_-- == 0;
    serial.run(cameToPass_ ? std::min(count, blocks_) : count, work);
    if (cameToPass_)
    {
      throw winding::Interrupted();
    }
  }

  bool cameToPass() const { return cameToPass_; }

private:
  int runs_;
  std::size_t blocks_;
  bool cameToPass_ = false;
};

/// Returns whether `work` ends without an interruption.
template <class Work> bool isCompleted(const Work& work)
{
  try
  {
    work();
    return true;
  }
  catch (const winding::Interrupted&)
  {
    return false;
  }
}

} // namespace shapes
