#include "PanelNames.h"

#include "vtkWindingNumberAlgorithm.h"

namespace winding
{

void usePanelNames()
{
  vtkWindingNumberAlgorithm::SetNamesInMessages(vtkWindingNumberAlgorithm::PARAVIEW_NAMES);
}

} // namespace winding
