// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkHDFReader.h"

/**
 * Reads VTKHDF by a VTK that knows no time steps, as before 9.3: its reader takes the parts of all
 * steps for one data set. The output is the first step, and TIME_STEPS has as many numbers as there
 * are steps. Throws Failure where the parts of the first step are not the first of the file.
 */
class HdfReader : public vtkHDFReader
{
public:
  static HdfReader* New();
  vtkTypeMacro(HdfReader, vtkHDFReader);

  HdfReader(const HdfReader&) = delete;
  void operator=(const HdfReader&) = delete;

protected:
  HdfReader() = default;
  ~HdfReader() override = default;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  int parts_ = 0; ///< of the first step; 0 for all that there are
};
