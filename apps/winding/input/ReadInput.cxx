#include "input/ReadInput.h"

#include "files/Formats.h"
#include "files/SinglePrecision.h"
#include "input/ContentCheck.h"
#include "input/ReaderProcess.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Progress.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSourceReader.h"

namespace
{

/// Warns where coordinates are in single precision, and lie so far from the origin that rounding
/// to it has moved them.
void warnOfLostDigits(vtkPointSet* data, const std::string& fileName, Messages& messages)
{
  if (data->GetNumberOfPoints() == 0 || data->GetPoints()->GetDataType() != VTK_FLOAT)
  {
    return;
  }
  const SinglePrecision precision = singlePrecisionOf(data);
  if (precision == SinglePrecision::movesPoints || precision == SinglePrecision::collapsesPoints)
  {
    messages.warn(
      fileName + ": its coordinates are kept in single precision, and so far from the " +
      "origin that vertices move by more than a ten-thousandth of its size; move it to " +
      "the origin, or use .vtp or .off with double precision");
  }
}

vtkSmartPointer<vtkPointSet> read(const std::string& fileName, Messages& messages)
{
  const std::string suffix = suffixOf(fileName);
  if ((' ' + inputSuffixes() + ' ').find(' ' + suffix + ' ') == std::string::npos)
  {
    throw Failure(
      EXIT_REFUSED, fileName, "has a suffix that is not known; give one of " + inputSuffixes());
  }
  if (const VtkFormat* const format = vtkFormatOf(suffix))
  {
    checkContentFits(fileName);
    return readInProcess(fileName, *format, messages);
  }
  vtkNew<vtkSourceReader> reader;
  reader->ReadAllColumnsOff();
  readBy(reader, fileName, messages);
  return reader->GetOutput();
}

} // namespace

vtkSmartPointer<vtkPointSet> readInput(const std::string& fileName, Messages& messages)
{
  messages.setSubject(fileName);
  auto data = read(fileName, messages);
  warnOfLostDigits(data, fileName, messages);
  return data;
}

void readBy(vtkSourceReader* reader, const std::string& fileName, Messages& messages)
{
  checkContentFits(fileName);
  messages.setSubject(fileName);
  reader->SetFileName(fileName.c_str());
  const Progress progress(reader, Phase::reading, messages.isQuiet());
  reader->Update();
  interrupt::check();
  messages.throwIfError(fileName);
}
