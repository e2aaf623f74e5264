// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace winding
{

/**
 * Tells ParaView which colours arrays have unless its user chooses others. WindingNumber is blue at
 * 0, pale at 0.5, where inside begins, and red at 1. Where two solids overlap, beyond 1.25, it is
 * orange, where more do, beyond 2.5, brown, and what looks inward, below −0.6, is green. The range
 * stays whatever the data has, so that clouds, whose winding numbers are large near their points,
 * show inside and outside, too. SignedDistance is red inside, pale at 0 and blue outside. FaultKind
 * has a colour and a word for each kind.
 *
 * It adds to ParaView's settings, below the user's and the site's. A second call changes
 * nothing.
 */
void setColorDefaults();

} // namespace winding
