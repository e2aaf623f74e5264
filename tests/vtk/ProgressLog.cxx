// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ProgressLog.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

ProgressLog::ProgressLog(vtkAlgorithm* filter, double abortFrom)
  : filter_(filter)
  , abortFrom_(abortFrom)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long, void* log, void* progress)
    { static_cast<ProgressLog*>(log)->follow(*static_cast<double*>(progress)); });
  tag_ = filter->AddObserver(vtkCommand::ProgressEvent, command);
}

ProgressLog::~ProgressLog()
{
  filter_->RemoveObserver(tag_);
  filter_->SetAbortExecute(0);
}

void ProgressLog::follow(double progress)
{
  isRising_ = isRising_ && progress >= last_;
  last_ = progress;
  ++events_;
  if (progress >= abortFrom_ && progress < 1)
  {
    abortedAt_ = abortedAt_ > 0 ? abortedAt_ : progress;
    filter_->SetAbortExecute(1);
  }
}
