#pragma once

namespace winding
{

/// Has messages of filters name properties by the labels of ParaView's panels.
void usePanelNames();

} // namespace winding
