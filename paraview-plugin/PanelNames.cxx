// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PanelNames.h"

#include "vtkWindingNumberAlgorithm.h"

namespace winding
{

void usePanelNames()
{
  vtkWindingNumberAlgorithm::SetNamesInMessages(vtkWindingNumberAlgorithm::PARAVIEW_NAMES);
}

} // namespace winding
