// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkXMLHyperTreeGridWriter.h"

/**
 * Writes .htg files of hyper tree grids whose trees are breadth first and have their numbers one
 * behind the other, as vtkWindingNumberHyperTree's are.
 *
 * VTK's own writer brings any trees into that order, by a list that takes 8 bytes for each vertex
 * and as much again while it grows: 1 GB for 4096³ voxels, which are 0.2 GB themselves. It also
 * writes several arrays to one place in appended mode (VTK 9.1), so data are inline here.
 */
class HyperTreeWriter : public vtkXMLHyperTreeGridWriter
{
public:
  static HyperTreeWriter* New();
  vtkTypeMacro(HyperTreeWriter, vtkXMLHyperTreeGridWriter);

protected:
  HyperTreeWriter();
  int WriteData() override;

private:
  void writeTrees(vtkIndent indent);
};
