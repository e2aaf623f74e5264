// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/ImageFile.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "output/OutputFile.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <vector>

namespace
{

constexpr bool isBigEndian = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

/// A type of voxels by its names in each format.
struct VoxelType
{
  int type;
  const char* inMeta;
  const char* inNrrd;
  std::int16_t inNifti;
};

constexpr VoxelType types[] = {{VTK_UNSIGNED_CHAR, "MET_UCHAR", "uchar", 2},
  {VTK_UNSIGNED_SHORT, "MET_USHORT", "ushort", 512}, {VTK_FLOAT, "MET_FLOAT", "float", 16},
  {VTK_DOUBLE, "MET_DOUBLE", "double", 64}};

/// Throws Failure for numbers of any other type.
const VoxelType& typeOf(vtkDataArray* values)
{
  const auto* const found = std::find_if(std::begin(types), std::end(types),
    [values](const VoxelType& candidate) { return candidate.type == values->GetDataType(); });
  if (found == std::end(types))
  {
    throw Failure(
      EXIT_REFUSED, std::string("medical images are not written with numbers of type ") +
                      values->GetDataTypeAsString());
  }
  return *found;
}

/// The place of an image in the coordinates of a space, at a scale: the first voxel, and the
/// directions as columns.
struct Place
{
  int dimensions[3];
  double origin[3], spacing[3], directions[3][3];
};

Place placeIn(ImageSpace space, const PlacedImage& placed, double scale = 1)
{
  vtkImageData* const image = placed.image;
  const std::array<double, 3> signs = signsBetween(placed.space, space);
  Place place;
  image->GetDimensions(place.dimensions);
  image->GetSpacing(place.spacing);
  const int* const extent = image->GetExtent();
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], place.origin);
  for (int row = 0; row < 3; ++row)
  {
    const double sign = signs[static_cast<std::size_t>(row)];
    place.origin[row] = scale * sign * place.origin[row] + 0.0; // and no −0
    for (int axis = 0; axis < 3; ++axis)
    {
      // These formats have no negative spacings.
      const double turned = place.spacing[axis] < 0 ? -sign : sign;
      place.directions[row][axis] =
        turned * image->GetDirectionMatrix()->GetElement(row, axis) + 0.0;
    }
  }
  for (double& spacing : place.spacing)
  {
    spacing = scale * (spacing == 0 ? 1 : std::abs(spacing)); // 0 of a single layer
  }
  return place;
}

/// Returns the text of a value behind a key in .nrrd, on one line.
std::string escaped(const std::string& value)
{
  std::string text;
  for (const char c : value)
  {
    text += c == '\\' ? "\\\\" : std::string(1, c);
  }
  return text;
}

/// Returns the names of labels by the keys that Slicer has in .nrrd, with a sign behind each key.
/// Nothing for images without names.
std::string namesOfLabels(vtkImageData* image, const std::string& sign)
{
  vtkDataArray* const values = image->GetFieldData()->GetArray("LabelValues");
  auto* const names =
    vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("LabelNames"));
  std::string lines;
  for (vtkIdType i = 0; values && names && i < values->GetNumberOfTuples(); ++i)
  {
    const std::string key = "Segment" + std::to_string(i), label = exact(values->GetTuple1(i));
    std::string name = names->GetValue(i);
    std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < ' '; }, ' ');
    lines += key + "_ID" + sign + "Segment_" + label + '\n';
    lines += key + "_Name" + sign + (sign == ":=" ? escaped(name) : name) + '\n';
    lines += key + "_LabelValue" + sign + label + '\n';
    lines += key + "_Layer" + sign + "0\n";
  }
  return lines;
}

/// Packs bytes, as zlib does or, if `asGzip`, as gzip does.
class Packer
{
public:
  explicit Packer(bool asGzip)
  {
    constexpr int gzip = 16, fast = 1, memory = 8;
    if (deflateInit2(&stream_, fast, Z_DEFLATED, (asGzip ? gzip : 0) + MAX_WBITS, memory,
          Z_DEFAULT_STRATEGY) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Packer() { deflateEnd(&stream_); }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  /// Packs more bytes, the last of all if `isLast`, and hands what comes out to `write`.
  template <class Write>
  void add(const void* bytes, std::size_t count, bool isLast, const Write& write)
  {
    stream_.next_in = static_cast<Bytef*>(const_cast<void*>(bytes));
    stream_.avail_in = static_cast<uInt>(count);
    do
    {
      stream_.next_out = reinterpret_cast<Bytef*>(buffer_.data());
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      deflate(&stream_, isLast ? Z_FINISH : Z_NO_FLUSH);
      write(buffer_.data(), buffer_.size() - stream_.avail_out);
    } while (stream_.avail_out == 0);
  }

private:
  z_stream stream_ = {};
  std::vector<char> buffer_ = std::vector<char>(1 << 18);
};

/// Writes into the temporary file.
class Stream
{
public:
  explicit Stream(OutputFile& file)
    : file_(file)
    , stream_(file.temporaryName(), std::ios::binary)
  {
  }

  void write(const char* bytes, std::size_t count)
  {
    interrupt::check();
    stream_.write(bytes, static_cast<std::streamsize>(count));
    if (!stream_)
    {
      file_.refuseWriting();
    }
  }
  void write(const std::string& text) { this->write(text.data(), text.size()); }

  /// Goes back, and writes over what stands there.
  void replace(std::size_t at, const std::string& text)
  {
    stream_.seekp(static_cast<std::streamoff>(at));
    this->write(text);
  }

  void close()
  {
    stream_.close();
    if (!stream_)
    {
      file_.refuseWriting();
    }
  }

private:
  OutputFile& file_;
  std::ofstream stream_;
};

/// Calls work(bytes, count, isLast) for the values of an array, some at a time.
template <class Work> void forEachChunk(vtkDataArray* values, const Work& work)
{
  constexpr std::size_t most = 1 << 22; // bytes; an interrupt is answered in between
  const auto* const bytes = static_cast<const char*>(values->GetVoidPointer(0));
  const std::size_t all = static_cast<std::size_t>(values->GetNumberOfValues()) *
                          static_cast<std::size_t>(values->GetDataTypeSize());
  for (std::size_t start = 0; start < all || start == 0; start += most)
  {
    const std::size_t count = std::min(most, all - start);
    work(bytes + start, count, start + most >= all);
  }
}

/// Writes values packed, and returns how many bytes these are.
std::size_t writePacked(
  vtkDataArray* values, bool asGzip, const std::string& before, Stream& stream)
{
  Packer packer(asGzip);
  std::size_t size = 0;
  const auto write = [&](const char* bytes, std::size_t count)
  {
    stream.write(bytes, count);
    size += count;
  };
  if (!before.empty())
  {
    packer.add(before.data(), before.size(), false, write);
  }
  forEachChunk(values, [&](const char* bytes, std::size_t count, bool isLast)
    { packer.add(bytes, count, isLast, write); });
  return size;
}

void writeMeta(const PlacedImage& placed, vtkDataArray* values, Stream& stream)
{
  const Place place = placeIn(ImageSpace::lps, placed, inMillimetres(placed.unit));
  std::string head = std::string("ObjectType = Image\nNDims = 3\nBinaryData = True\n"
                                 "BinaryDataByteOrderMSB = ") +
                     (isBigEndian ? "True" : "False") +
                     "\nCompressedData = True\nCompressedDataSize = ";
  const std::size_t placeOfSize = head.size();
  const std::string noSize(20, ' ');
  head += noSize + "\nTransformMatrix =";
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const auto& row : place.directions)
    {
      head += ' ' + exact(row[axis]);
    }
  }
  head += "\nOffset = " + exact(place.origin, ' ') +
          "\nCenterOfRotation = 0 0 0\nElementSpacing = " + exact(place.spacing, ' ') +
          "\nDimSize =";
  for (const int count : place.dimensions)
  {
    head += ' ' + std::to_string(count);
  }
  head += '\n' + namesOfLabels(placed.image, " = ") + "ElementType = " + typeOf(values).inMeta +
          "\nElementDataFile = LOCAL\n";
  stream.write(head);
  const std::string size = std::to_string(writePacked(values, false, "", stream));
  stream.replace(placeOfSize, size);
}

void writeNrrd(const PlacedImage& placed, vtkDataArray* values, Stream& stream)
{
  const ImageSpace space = placed.space == ImageSpace::unnamed ? ImageSpace::lps : placed.space;
  const Place place = placeIn(space, placed, inMillimetres(placed.unit));
  std::string head = std::string("NRRD0004\n# by winding\ntype: ") + typeOf(values).inNrrd +
                     "\ndimension: 3\nspace: " + nameOf(space) + "\nsizes:";
  for (const int count : place.dimensions)
  {
    head += ' ' + std::to_string(count);
  }
  head += "\nspace directions:";
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = place.spacing[axis];
    const double step[3] = {place.directions[0][axis] * spacing,
      place.directions[1][axis] * spacing, place.directions[2][axis] * spacing};
    head += " (" + exact(step, ',') + ')';
  }
  head += std::string("\nkinds: domain domain domain\nendian: ") +
          (isBigEndian ? "big" : "little") + "\nencoding: gzip\nspace origin: (" +
          exact(place.origin, ',') + ")\n" +
          (placed.spaceUnits.empty() ? "" : "space units: " + placed.spaceUnits + '\n') +
          namesOfLabels(placed.image, ":=") + '\n';
  stream.write(head);
  writePacked(values, true, "", stream);
}

template <class Number> void put(std::string& header, std::size_t at, Number number)
{
  std::memcpy(header.data() + at, &number, sizeof number);
}

void put(std::string& header, std::size_t at, double number)
{
  put(header, at, static_cast<float>(number));
}

/// Directions at right angles as NIfTI keeps them: a quaternion (a, b, c, d), and a sign for a
/// third axis that is mirrored.
struct Turn
{
  double quaternion[4], handed;
};

/// Returns the turn that is nearest to directions.
Turn nearestTurn(const Place& place)
{
  Turn turn;
  double columns[3][3];
  std::memcpy(columns, place.directions, sizeof columns);
  turn.handed = vtkMath::Determinant3x3(columns) < 0 ? -1 : 1;
  for (auto& row : columns)
  {
    row[2] *= turn.handed;
  }
  vtkMath::Matrix3x3ToQuaternion(columns, turn.quaternion);
  for (double& number : turn.quaternion)
  {
    number = number + 0.0; // and no −0
  }
  return turn;
}

/// Puts a turn into a header of NIfTI-1: three of its numbers, as the first is not negative.
void putTurn(std::string& header, const Turn& turn)
{
  const double sign = turn.quaternion[0] < 0 ? -1 : 1;
  for (std::size_t n = 0; n < 3; ++n)
  {
    put(header, 256 + 4 * n, sign * turn.quaternion[n + 1] + 0.0);
  }
  put(header, 76, turn.handed);
}

/// Returns how far single precision moves a voxel at most, as a share of the shortest step, where
/// the steps have these directions instead of the own ones.
double largestMove(const Place& place, const double directions[3][3])
{
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double move[3];
    for (int row = 0; row < 3; ++row)
    {
      move[row] = static_cast<float>(place.origin[row]) - place.origin[row];
      for (int axis = 0; axis < 3; ++axis)
      {
        const int steps = (corner >> axis & 1) * (place.dimensions[axis] - 1);
        const double spacing = place.spacing[axis];
        move[row] += steps * (static_cast<float>(directions[row][axis] * spacing) -
                               place.directions[row][axis] * spacing);
      }
    }
    largest = std::max(largest, std::hypot(move[0], move[1], move[2]));
  }
  return largest / *std::min_element(place.spacing, place.spacing + 3);
}

/// Throws Failure for more voxels along an axis than NIfTI-1 counts.
void checkDimensions(const int dimensions[3], const std::string& fileName)
{
  const int most = *std::max_element(dimensions, dimensions + 3);
  if (most > std::numeric_limits<std::int16_t>::max())
  {
    throw Failure(EXIT_REFUSED, fileName,
      "cannot hold " + std::to_string(most) + " voxels along an axis; give it the suffix .nrrd");
  }
}

/// Returns a number with three decimals at most.
std::string rounded(double number)
{
  constexpr double most = 1e3;
  return exact(std::round(number * most) / most);
}

/// The header of NIfTI-1, with both of its transforms.
std::string niftiHeader(const PlacedImage& placed, vtkDataArray* values, const OutputFile& file)
{
  const Place place = placeIn(ImageSpace::ras, placed);
  checkDimensions(place.dimensions, file.name());
  constexpr std::size_t size = 352; // without extensions
  std::string header(size, '\0');
  put(header, 0, std::int32_t(348));
  header[38] = 'r'; // as Analyze has it
  put(header, 40, std::int16_t(3));
  for (std::size_t axis = 0; axis < 7; ++axis)
  {
    const int count = axis < 3 ? place.dimensions[axis] : 1;
    put(header, 42 + 2 * axis, static_cast<std::int16_t>(count));
    put(header, 80 + 4 * axis, axis < 3 ? place.spacing[axis] : 1.0);
  }
  put(header, 70, typeOf(values).inNifti);
  put(header, 72, static_cast<std::int16_t>(8 * values->GetDataTypeSize()));
  put(header, 108, static_cast<double>(size));
  put(header, 112, 1.0); // slope
  header[123] = static_cast<char>(placed.unit);
  const NiftiForms forms = placed.forms.value_or(NiftiForms());
  put(header, 252, static_cast<std::int16_t>(forms.qform));
  put(header, 254, static_cast<std::int16_t>(forms.sform));
  putTurn(header, nearestTurn(place));
  const bool hasOwnTurn = placed.forms && forms.qform > 0 && forms.sform > 0;
  for (std::size_t n = 0; n < 4 && hasOwnTurn; ++n)
  {
    put(header, 76 + 4 * n, forms.steps[n]);
    put(header, 256 + 4 * n, n < 3 ? forms.quaternion[n] : forms.offset[0]);
  }
  for (std::size_t row = 0; row < 3; ++row)
  {
    put(header, 268 + 4 * row, hasOwnTurn ? forms.offset[row] : place.origin[row]);
    put(header, 292 + 16 * row, place.origin[row]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      put(header, 280 + 16 * row + 4 * axis, place.directions[row][axis] * place.spacing[axis]);
    }
  }
  header.replace(148, 7, "winding");
  header.replace(344, 3, "n+1");
  return header;
}

} // namespace

void checkMedicalImage(const PlacedImage& placed, const std::string& fileName, Messages& messages)
{
  const std::string suffix = suffixOf(fileName);
  if (suffix != ".nii" && suffix != ".nii.gz")
  {
    return;
  }
  const Place place = placeIn(ImageSpace::ras, placed);
  checkDimensions(place.dimensions, fileName);
  constexpr double acceptable = 0.01, acceptableTurn = 0.1, fatal = 0.5;
  const double move = largestMove(place, place.directions);
  const std::string words = "its places are in single precision, which moves voxels by up to " +
                            rounded(move) + " of their side; give it the suffix .nrrd";
  if (!(move < fatal))
  {
    throw Failure(EXIT_REFUSED, fileName, words);
  }
  if (move > acceptable)
  {
    messages.warn(fileName + ": " + words);
    return;
  }
  if (placed.forms && (placed.forms->qform <= 0 || placed.forms->sform > 0))
  {
    return; // there is no qform, or the image's own
  }
  const Turn turn = nearestTurn(place);
  double directions[3][3];
  vtkMath::QuaternionToMatrix3x3(turn.quaternion, directions);
  for (auto& row : directions)
  {
    row[2] *= turn.handed;
  }
  if (const double turned = largestMove(place, directions); turned > acceptableTurn)
  {
    messages.warn(fileName +
                  ": the axes of the image are not quite at right angles, and programs " +
                  "that read the qform see voxels up to " + rounded(turned) +
                  " of their side away; give it the suffix .nrrd");
  }
}

void writeMedicalImage(const PlacedImage& placed, OutputFile& file)
{
  vtkDataArray* const values = placed.image->GetPointData()->GetScalars();
  const std::string suffix = suffixOf(file.name());
  Stream stream(file);
  if (suffix == ".mha")
  {
    writeMeta(placed, values, stream);
  }
  else if (suffix == ".nrrd")
  {
    writeNrrd(placed, values, stream);
  }
  else
  {
    const std::string header = niftiHeader(placed, values, file);
    if (suffix == ".nii.gz")
    {
      writePacked(values, true, header, stream);
    }
    else
    {
      stream.write(header);
      forEachChunk(values,
        [&stream](const char* bytes, std::size_t count, bool) { stream.write(bytes, count); });
    }
  }
  stream.close();
  file.checkIsWhole();
}
