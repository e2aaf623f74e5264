#pragma once

namespace winding
{

/**
 * Tells ParaView which colours the array WindingNumber has unless its user chooses others: blue at
 * 0, pale at 0.5, where inside begins, and red at 1. The range stays 0 to 1 whatever the data has,
 * so that clouds, whose winding numbers are large beside their points, show inside and outside, too.
 *
 * It adds to ParaView's settings, below those of the user and of the site. A second call changes
 * nothing.
 */
void setColorDefaults();

} // namespace winding
