#include "output/ImageFile.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "output/OutputFile.h"
#include "program/Failure.h"
#include "program/Interrupt.h"

#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
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

const VoxelType& typeOf(vtkDataArray* values)
{
  return *std::find_if(std::begin(types), std::end(types),
    [values](const VoxelType& candidate) { return candidate.type == values->GetDataType(); });
}

/// The place of an image in the coordinates of a space: the first voxel, and the directions as
/// columns.
struct Place
{
  int dimensions[3];
  double origin[3], spacing[3], directions[3][3];
};

Place placeIn(ImageSpace space, const PlacedImage& placed)
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
    place.origin[row] = sign * place.origin[row] + 0.0; // and no −0
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
    spacing = spacing == 0 ? 1 : std::abs(spacing); // of a single layer
  }
  return place;
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
  const Place place = placeIn(ImageSpace::lps, placed);
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
          "\nCenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing = " +
          exact(place.spacing, ' ') + "\nDimSize =";
  for (const int count : place.dimensions)
  {
    head += ' ' + std::to_string(count);
  }
  head += std::string("\nElementType = ") + typeOf(values).inMeta + "\nElementDataFile = LOCAL\n";
  stream.write(head);
  const std::string size = std::to_string(writePacked(values, false, "", stream));
  stream.replace(placeOfSize, size);
}

void writeNrrd(const PlacedImage& placed, vtkDataArray* values, Stream& stream)
{
  const ImageSpace space = placed.space == ImageSpace::unnamed ? ImageSpace::lps : placed.space;
  const Place place = placeIn(space, placed);
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
          exact(place.origin, ',') + ")\n\n";
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

/// Puts the directions into a header of NIfTI-1 as a quaternion (a, b, c, d), without a, by the
/// largest of its four numbers. A third axis that is mirrored has a sign of its own.
void putQuaternion(std::string& header, const Place& place)
{
  double m[3][3];
  std::memcpy(m, place.directions, sizeof m);
  const double volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                        m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                        m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  for (auto& row : m)
  {
    row[2] *= volume < 0 ? -1 : 1;
  }
  // Four times the products of each number with all of them.
  const double products[4][4] = {
    {1 + m[0][0] + m[1][1] + m[2][2], m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]},
    {m[2][1] - m[1][2], 1 + m[0][0] - m[1][1] - m[2][2], m[1][0] + m[0][1], m[0][2] + m[2][0]},
    {m[0][2] - m[2][0], m[1][0] + m[0][1], 1 - m[0][0] + m[1][1] - m[2][2], m[2][1] + m[1][2]},
    {m[1][0] - m[0][1], m[0][2] + m[2][0], m[2][1] + m[1][2], 1 - m[0][0] - m[1][1] + m[2][2]}};
  int largest = 0;
  for (int n = 1; n < 4; ++n)
  {
    largest = products[n][n] > products[largest][largest] ? n : largest;
  }
  const double* const row = products[largest];
  const double length =
    std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2] + row[3] * row[3]);
  const double sign = row[0] < 0 ? -1 : 1; // of a, which is not negative there
  for (std::size_t n = 0; n < 3; ++n)
  {
    put(header, 256 + 4 * n, sign * row[n + 1] / length);
  }
  put(header, 76, volume < 0 ? -1.0 : 1.0);
}

/// The header of NIfTI-1, with both of its transforms.
std::string niftiHeader(const PlacedImage& placed, vtkDataArray* values, const OutputFile& file)
{
  const Place place = placeIn(ImageSpace::ras, placed);
  constexpr std::size_t size = 352; // without extensions
  std::string header(size, '\0');
  put(header, 0, std::int32_t(348));
  header[38] = 'r'; // as Analyze has it
  put(header, 40, std::int16_t(3));
  for (std::size_t axis = 0; axis < 7; ++axis)
  {
    const int count = axis < 3 ? place.dimensions[axis] : 1;
    if (count > std::numeric_limits<std::int16_t>::max())
    {
      throw Failure(EXIT_REFUSED, file.name(),
        "cannot hold " + std::to_string(count) + " voxels along an axis; give it the suffix .nrrd");
    }
    put(header, 42 + 2 * axis, static_cast<std::int16_t>(count));
    put(header, 80 + 4 * axis, axis < 3 ? place.spacing[axis] : 1.0);
  }
  put(header, 70, typeOf(values).inNifti);
  put(header, 72, static_cast<std::int16_t>(8 * values->GetDataTypeSize()));
  put(header, 108, static_cast<double>(size));
  put(header, 112, 1.0); // slope
  constexpr std::int16_t scanner = 1;
  put(header, 252, scanner);
  put(header, 254, scanner);
  putQuaternion(header, place);
  for (std::size_t row = 0; row < 3; ++row)
  {
    put(header, 268 + 4 * row, place.origin[row]);
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
