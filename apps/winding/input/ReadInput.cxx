// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/ReadInput.h"

#include "files/Formats.h"
#include "files/SinglePrecision.h"
#include "input/ContentCheck.h"
#include "input/ImageHeader.h"
#include "input/Leaves.h"
#include "input/ReaderProcess.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Progress.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberAlgorithm.h"
#include "vtkWindingNumberReader.h"

namespace
{

/// Whether coordinates are in single precision, and lie so far from the origin that rounding to it
/// has moved them.
bool haveLostDigits(vtkPointSet* points)
{
  if (points->GetNumberOfPoints() == 0 || points->GetPoints()->GetDataType() != VTK_FLOAT)
  {
    return false;
  }
  const SinglePrecision precision = singlePrecisionOf(points);
  return precision == SinglePrecision::movesPoints || precision == SinglePrecision::collapsesPoints;
}

bool isOneOf(const std::string& suffix, const std::string& suffixes)
{
  return (' ' + suffixes + ' ').find(' ' + suffix + ' ') != std::string::npos;
}

/// Reads the place of a medical image. Warns where NIfTI says none.
PlacedImage readMedical(const std::string& fileName, Messages& messages)
{
  PlacedImage placed = readImageHeader(fileName);
  if (placed.forms && placed.forms->qform <= 0 && placed.forms->sform <= 0)
  {
    messages.warn(fileName +
                  ": its header does not say where it lies, for qform_code and sform_code are 0: " +
                  "set one of them; programs lay it in different places, this one its first " +
                  "voxel at 0 0 0");
  }
  return placed;
}

vtkSmartPointer<vtkDataObject> readByVtk(
  const std::string& fileName, const VtkFormat& format, Messages& messages)
{
  checkContentFits(fileName);
  return readInProcess(fileName, format, messages);
}

vtkSmartPointer<vtkDataObject> read(
  const std::string& fileName, Messages& messages, const ColumnOptions& columns)
{
  const std::string suffix = suffixOf(unpackedName(fileName));
  if (isOneOf(suffix, imageSuffixes()))
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is an image or a grid, and no surface or points; contour it first, or give it to winding "
      "probe or --like");
  }
  if (!isOneOf(suffix, inputSuffixes()))
  {
    throw Failure(EXIT_REFUSED, fileName,
      "has a suffix that is not known; give one of " + inputSuffixes() +
        ", those from .ply on also packed as .gz");
  }
  if (const VtkFormat* const format = vtkFormatOf(suffix))
  {
    return readByVtk(fileName, *format, messages);
  }
  vtkNew<vtkWindingNumberReader> reader;
  reader->SetReadAllColumns(columns.areAll);
  reader->SetColumns(columns.chosen.c_str());
  readBy(reader, fileName, messages);
  return reader->GetOutput();
}

} // namespace

vtkSmartPointer<vtkDataObject> readInput(
  const std::string& fileName, Messages& messages, const ColumnOptions& columns)
{
  messages.setSubject(fileName);
  auto data = read(fileName, messages, columns);
  bool areDigitsLost = false;
  forEachLeaf(data,
    [&](vtkDataObject* leaf) { areDigitsLost |= haveLostDigits(vtkPointSet::SafeDownCast(leaf)); });
  if (areDigitsLost)
  {
    messages.warn(
      fileName + ": its coordinates are kept in single precision, and so far from the " +
      "origin that vertices move by more than a ten-thousandth of its size; move it to " +
      "the origin, or use .vtp or .off with double precision");
  }
  return data;
}

vtkSmartPointer<vtkPointSet> readPoints(
  const std::string& fileName, Messages& messages, const ColumnOptions& columns)
{
  const auto data = readInput(fileName, messages, columns);
  vtkSmartPointer<vtkPointSet> points = vtkPointSet::SafeDownCast(data);
  if (!points)
  {
    throw Failure(EXIT_REFUSED, fileName, "has several blocks; give them as one data set");
  }
  return points;
}

vtkSmartPointer<vtkDataSet> readQueries(
  const std::string& fileName, Messages& messages, const ColumnOptions& columns)
{
  const std::string suffix = suffixOf(fileName);
  messages.setSubject(fileName);
  if (isMedical(suffix))
  {
    return readMedical(fileName, messages).image;
  }
  if (const VtkFormat* const format = vtkFormatOf(suffix); format && !format->isSource)
  {
    return vtkDataSet::SafeDownCast(readByVtk(fileName, *format, messages));
  }
  return readPoints(fileName, messages, columns);
}

PlacedImage readPlace(const std::string& fileName, Messages& messages)
{
  messages.setSubject(fileName);
  const std::string suffix = suffixOf(fileName);
  if (isMedical(suffix))
  {
    return readMedical(fileName, messages);
  }
  if (suffix != ".vti")
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is no image to lie on; give one of .vti .mha .mhd .nrrd .nhdr .nii .nii.gz");
  }
  const auto read = readByVtk(fileName, *vtkFormatOf(suffix), messages);
  PlacedImage place;
  place.image = vtkSmartPointer<vtkImageData>::New();
  place.image->CopyStructure(vtkDataSet::SafeDownCast(read));
  return place;
}

void readBy(vtkWindingNumberReader* reader, const std::string& fileName, Messages& messages)
{
  checkContentFits(fileName);
  messages.setSubject(fileName);
  reader->SetNamesInMessages(vtkWindingNumberAlgorithm::PROGRAM_NAMES);
  reader->SetFileName(fileName.c_str());
  const Progress progress(reader, Phase::reading, messages.isQuiet());
  reader->Update();
  interrupt::check();
  messages.throwIfError(fileName);
}
