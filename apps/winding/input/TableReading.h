#pragma once

#include "program/Progress.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"

/// Shows that a table is read while it lives, as Progress does for what an algorithm reads.
class TableReading
{
public:
  explicit TableReading(bool quiet)
    : progress_(reading_, Phase::reading, quiet)
  {
  }

  /// Says that so much has been read, from 0 to 1.
  void passed(double fraction) { reading_->UpdateProgress(fraction); }

private:
  vtkNew<vtkAlgorithm> reading_;
  Progress progress_;
};
