// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

/// Follows the progress of a filter as long as it lives, and aborts the filter where told to.
class ProgressLog
{
public:
  /// abortFrom: the progress, of 0 to 1, from which on the filter is aborted; a progress of 1 is
  /// too late.
  explicit ProgressLog(
    vtkAlgorithm* filter, double abortFrom = std::numeric_limits<double>::infinity());
  ~ProgressLog();
  ProgressLog(const ProgressLog&) = delete;
  ProgressLog& operator=(const ProgressLog&) = delete;

  double last() const { return last_; }

  /// The progress at which the filter was aborted, 0 if it was not. VTK 9.2 tells of a progress of
  /// 1 after that.
  double abortedAt() const { return abortedAt_; }

  bool isRising() const { return isRising_; }
  int events() const { return events_; }

private:
  void follow(double progress);

  vtkAlgorithm* filter_;
  double abortFrom_;
  unsigned long tag_;
  double last_ = 0;
  double abortedAt_ = 0;
  bool isRising_ = true;
  int events_ = 0;
};
