#include "commands/FilterOutcome.h"

#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"

#include "vtkWindingNumberAlgorithm.h"

void checkFilter(int status, const std::string& fileName, Messages& messages)
{
  interrupt::check();
  try
  {
    messages.throwIfError(fileName);
  }
  catch (const Failure& failure)
  {
    throw Failure(
      status == vtkWindingNumberAlgorithm::OUT_OF_MEMORY ? EXIT_NO_MEMORY : EXIT_REFUSED,
      failure.what());
  }
  if (status == vtkWindingNumberAlgorithm::ABORTED)
  {
    throw Failure(EXIT_INTERRUPTED, "interrupted"); // on another rank
  }
  if (status != vtkWindingNumberAlgorithm::DONE)
  {
    throw Failure(EXIT_REFUSED, fileName, "the winding field could not be made");
  }
}
