// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace winding
{

/// Has messages of filters name properties by the labels of ParaView's panels.
void usePanelNames();

} // namespace winding
