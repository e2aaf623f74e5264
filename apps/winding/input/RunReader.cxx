#include "input/RunReader.h"

#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Progress.h"

#include "vtkAlgorithm.h"

void runReader(vtkAlgorithm* reader, const std::string& fileName, Messages& messages)
{
  const Progress progress(reader, Phase::reading, messages.isQuiet());
  reader->Update();
  interrupt::check();
  messages.throwIfError(fileName);
}
