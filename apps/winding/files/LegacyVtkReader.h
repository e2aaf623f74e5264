// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkDataSetReader.h"

/**
 * VTK's reader of legacy files, with all arrays, and with numbers that are not finite in files of
 * text: VTK writes them as nan and inf, and refuses them. Files of text with string arrays are read
 * as VTK reads them.
 */
class LegacyVtkReader : public vtkDataSetReader
{
public:
  static LegacyVtkReader* New();
  vtkTypeMacro(LegacyVtkReader, vtkDataSetReader);

  int ReadMeshSimple(const std::string& fileName, vtkDataObject* output) override;

protected:
  LegacyVtkReader();
};
