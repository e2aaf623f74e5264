// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace winding
{

/**
 * Has this client of ParaView look at every new result of the plugin's filters, which ParaView
 * itself does not do:
 * - Properties that report on the last execution are read again, so that the panel is never one
 *   execution behind.
 * - A slice of an image stays where it was in the bounds when the number of voxels changes, and an
 *   image without any is shown as its outline.
 * - The colours of "SignedDistance" reach as far below 0 as above, unless their range was changed.
 * - Labels and operands have a colour each, and their names are the legend's, in each result's own
 *   map of colours.
 *
 * A second call changes nothing, and neither does one on a server.
 */
void followResults();

} // namespace winding
