// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/ImageHeader.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "input/MetaHeader.h"
#include "input/NiftiHeader.h"
#include "input/NrrdHeader.h"
#include "program/Failure.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace
{

/// Headers as text may be long, for programs write notes of their own into them, and this one names
/// of up to 65535 labels.
constexpr std::size_t mostBytes = std::size_t(1) << 24;

/// Unpacks the first bytes of a file that was packed by gzip, in one part or several. Reads no more
/// of it. Throws Failure where the file ends before, or is damaged.
std::string unpackedBeginningOf(const std::string& fileName, unsigned int bytes)
{
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(fileName.c_str(), "rb"), gzclose);
  if (!file)
  {
    throw Failure(EXIT_REFUSED, fileName, "cannot be opened; check its permissions");
  }
  std::string beginning(bytes, '\0');
  const int count = gzread(file.get(), beginning.data(), bytes);
  int status = Z_OK;
  gzerror(file.get(), &status);
  // zlib 1.3.2 takes what is damaged from its first byte on for nothing, without an error.
  if (status != Z_OK || count <= 0)
  {
    throw Failure(EXIT_REFUSED, fileName,
      status == Z_BUF_ERROR ? "ends before it is unpacked; it is damaged, fetch it again"
      : status == Z_OK      ? "cannot be unpacked; it is damaged, or packs nothing"
                            : "cannot be unpacked; it is damaged, fetch it again");
  }
  beginning.resize(static_cast<std::size_t>(count));
  return beginning;
}

/// Gives an axis that is not there, of an image of two, a voxel as long as the longer side of the
/// others, across these.
void addThirdAxis(ImagePlace& place)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto& a = place.steps[(axis + 1) % 3];
    const auto& b = place.steps[(axis + 2) % 3];
    const double cross[3] = {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double area = std::hypot(cross[0], cross[1], cross[2]);
    if (place.dimensions[axis] <= 1 && place.steps[axis] == std::array<double, 3>() && area > 0)
    {
      const double longest = std::max(std::hypot(a[0], a[1], a[2]), std::hypot(b[0], b[1], b[2]));
      place.dimensions[axis] = 1;
      for (std::size_t row = 0; row < 3; ++row)
      {
        place.steps[axis][row] = cross[row] / area * longest;
      }
      return;
    }
  }
}

/// Makes an image without arrays at a place.
vtkSmartPointer<vtkImageData> imageAt(const ImagePlace& place)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  double samples = 1, longest = 0, spacings[3], directions[9];
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::array<double, 3>& step = place.steps[static_cast<std::size_t>(axis)];
    const double spacing = std::hypot(step[0], step[1], step[2]);
    if (!(spacing > 0 && std::isfinite(spacing)))
    {
      throw HeaderFault("its voxels have no size along an axis");
    }
    spacings[axis] = spacing;
    for (int row = 0; row < 3; ++row)
    {
      directions[3 * row + axis] = step[static_cast<std::size_t>(row)] / spacing;
    }
    const double length = place.dimensions[static_cast<std::size_t>(axis)];
    longest = std::max(longest, length);
    samples *= length;
  }
  constexpr double most = 1e15, mostAlongAxis = 1e8; // VTK 9.6 stores the coordinates of each axis
  if (samples > most || longest > mostAlongAxis)
  {
    throw HeaderFault("its header counts more voxels than there can be");
  }
  image->SetDirectionMatrix(directions);
  constexpr double leastVolume = 1e-6;
  if (!(std::abs(image->GetDirectionMatrix()->Determinant()) > leastVolume))
  {
    throw HeaderFault("its axes lie in a plane");
  }
  image->SetSpacing(spacings);
  const auto& n = place.dimensions;
  image->SetDimensions(n[0], n[1], n[2]);
  image->SetOrigin(place.origin.data());
  return image;
}

} // namespace

PlacedImage placedImage(
  const std::string& head, const std::string& suffix, const std::string& fileName)
{
  try
  {
    ImagePlace place = suffix == ".mha" || suffix == ".mhd"     ? metaImage(head)
                       : suffix == ".nrrd" || suffix == ".nhdr" ? nrrdImage(head)
                                                                : niftiImage(head);
    addThirdAxis(place);
    return {imageAt(place), place.space, place.unit, place.spaceUnits, place.forms};
  }
  catch (const HeaderFault& fault)
  {
    throw Failure(EXIT_REFUSED, fileName,
      std::string("is not ") + (suffix.c_str() + 1) + ": " + fault.what() + "; give another file");
  }
}

PlacedImage readImageHeader(const std::string& fileName)
{
  std::string head = beginningOf(fileName, mostBytes);
  const std::string suffix = suffixOf(fileName);
  if (head.rfind("\x1f\x8b", 0) == 0 && (suffix == ".nii" || suffix == ".nii.gz"))
  {
    head = unpackedBeginningOf(fileName, bytesOfNiftiHeader);
  }
  return placedImage(head, suffix, fileName);
}

std::vector<std::string> voxelFilesOf(const std::string& fileName)
{
  std::vector<std::string> names;
  try
  {
    const std::string head = beginningOf(fileName, mostBytes);
    std::size_t start = 0;
    const bool isNrrd = startsWith(head, "NRRD");
    const HeaderFields fields = isNrrd ? nrrdFields(head, start) : metaFields(head, start);
    const std::string* const name = findAny(fields, {"ElementDataFile", "datafile"});
    if (name && startsWith(*name, "LIST"))
    {
      while (start < head.size())
      {
        names.emplace_back(takeHeaderLine(head, start));
      }
    }
    else if (name && inSmallLetters(*name) != "local")
    {
      names.push_back(*name);
    }
  }
  catch (const std::runtime_error&) // whoever reads the header refuses it
  {
  }
  return names;
}
