#include "input/ImageHeader.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "input/NiftiHeader.h"
#include "program/Failure.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace
{

/// Headers as text may be long, for programs write notes of their own into them, and this one names
/// of up to 65535 labels.
constexpr std::size_t mostBytes = std::size_t(1) << 24;

[[noreturn]] void refuse(const std::string& message)
{
  throw HeaderFault(message);
}

/// Takes blanks off both ends of a text.
std::string_view trimmed(std::string_view text)
{
  const std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos
           ? std::string_view()
           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

double numberOf(std::string_view word, const std::string& key)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1); // from_chars() knows no plus sign
  }
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
  {
    refuse("its header has no number in '" + key + "'");
  }
  return value;
}

/// Throws HeaderFault for a field that has another number of numbers than `wanted`.
void checkCount(std::size_t found, const std::string& key, std::size_t wanted)
{
  if (found != wanted)
  {
    refuse("its header has " + std::to_string(found) + " numbers in '" + key + "', not " +
           std::to_string(wanted));
  }
}

/// Reads the `count` numbers of a field.
std::vector<double> numbersOf(std::string_view text, const std::string& key, std::size_t count)
{
  std::vector<double> numbers;
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
  {
    numbers.push_back(numberOf(word, key));
  }
  checkCount(numbers.size(), key, count);
  return numbers;
}

int sizeOf(double value, const std::string& key)
{
  if (!(value >= 1 && value <= VTK_INT_MAX && value == std::floor(value)))
  {
    refuse("its header has no number of voxels in '" + key + "'");
  }
  return static_cast<int>(value);
}

/// The fields of a header by their keys.
using Fields = std::map<std::string, std::string>;

/// Returns the first of some fields that is there; null if none is.
const std::string* findAny(const Fields& fields, const std::vector<const char*>& keys)
{
  for (const char* key : keys)
  {
    if (const auto found = fields.find(key); found != fields.end())
    {
      return &found->second;
    }
  }
  return nullptr;
}

/// Takes the next line off a header as text. Throws HeaderFault behind the last one: the file has
/// another kind of data, or is cut off.
std::string_view takeHeaderLine(const std::string& head, std::size_t& start)
{
  if (start >= head.size())
  {
    refuse("its header has no end");
  }
  return trimmed(takeLine(head, start));
}

/// Reads the fields of a MetaImage, up to ElementDataFile. Its values stand behind = or a colon.
Fields metaFields(const std::string& head)
{
  Fields fields;
  std::size_t start = 0;
  while (fields.count("ElementDataFile") == 0)
  {
    const std::string_view line = takeHeaderLine(head, start);
    if (const std::size_t at = line.find_first_of("=:"); at != std::string_view::npos)
    {
      fields[std::string(trimmed(line.substr(0, at)))] = trimmed(line.substr(at + 1));
    }
  }
  return fields;
}

/// Returns the name of a field of NRRD in small letters and without blanks. Teem ignores case, and
/// has names of several words in both ways.
std::string nrrdName(std::string_view name)
{
  std::string plain = inSmallLetters(name);
  plain.erase(std::remove(plain.begin(), plain.end(), ' '), plain.end());
  return plain;
}

/// The fields that the format has, by nrrdName(). The ones in the second row say where voxels are.
constexpr std::string_view nrrdNames[] = {"content", "number", "type", "blocksize", "thicknesses",
  "labels", "units", "min", "max", "oldmin", "oldmax", "endian", "encoding", "lineskip", "byteskip",
  "sampleunits", "datafile", "spaceunits", "measurementframe", //
  "dimension", "sizes", "spacings", "axismins", "axismaxs", "centers", "centerings", "kinds",
  "space", "spacedimension", "spacedirections", "spaceorigin"};

/// Adds the field in a line. A line that is none is refused, as Teem does, for it may be a place
/// with a typing error.
void addNrrdField(std::string_view line, Fields& fields)
{
  const std::size_t at = std::min(line.find(':'), line.size());
  if (line.front() == '#' || line.substr(at, 2) == ":=")
  {
    return; // a comment, or the key of a user
  }
  const std::string name(trimmed(line.substr(0, at))), plain = nrrdName(name);
  if (at == line.size() ||
      std::find(std::begin(nrrdNames), std::end(nrrdNames), plain) == std::end(nrrdNames))
  {
    refuse("its header has '" + name.substr(0, 30) + "', which is no field of the format");
  }
  if (!fields.emplace(plain, trimmed(line.substr(at + 1))).second)
  {
    refuse("its header has '" + name + "' twice");
  }
}

/// Reads the fields of a NRRD by nrrdName(), up to an empty line. A header that names files with
/// the data may end without one, or with a list of them.
Fields nrrdFields(const std::string& head)
{
  Fields fields;
  std::size_t start = 0;
  takeHeaderLine(head, start); // the format's name
  const auto hasEnded = [&]
  {
    const std::string* const data = findAny(fields, {"datafile"});
    return data && (start >= head.size() || data->rfind("LIST", 0) == 0);
  };
  while (!hasEnded())
  {
    const std::string_view line = takeHeaderLine(head, start);
    if (line.empty())
    {
      break;
    }
    addNrrdField(line, fields);
  }
  return fields;
}

/// Returns the number of axes that a field says. Three at most are of space.
std::size_t axesOf(const Fields& fields, const char* key)
{
  const std::string* const text = findAny(fields, {key});
  if (!text)
  {
    refuse(std::string("its header has no '") + key + "'");
  }
  constexpr double most = 16; // of NRRD
  const double axes = numberOf(*text, key);
  if (!(axes >= 2 && axes <= most && axes == std::floor(axes)))
  {
    refuse(std::string("its header has another number of axes in '") + key + "' than 2 to 16");
  }
  return static_cast<std::size_t>(axes);
}

/// Refuses an axis of space that goes along time as well.
void checkStep(const std::vector<double>& step)
{
  if (std::any_of(
        step.begin() + std::min<std::ptrdiff_t>(3, static_cast<std::ptrdiff_t>(step.size())),
        step.end(), [](double number) { return number != 0; }))
  {
    refuse("its axes of space and time are mixed");
  }
}

ImagePlace metaImage(const std::string& head)
{
  const Fields fields = metaFields(head);
  const std::size_t axes = axesOf(fields, "NDims"), ofSpace = std::min<std::size_t>(axes, 3);
  const auto read = [&](const std::vector<const char*>& keys, std::size_t count)
  {
    const std::string* const text = findAny(fields, keys);
    return text ? numbersOf(*text, keys.front(), count) : std::vector<double>();
  };
  const std::vector<double> sizes = read({"DimSize"}, axes);
  // The directions of the axes follow each other.
  const std::vector<double> directions =
    read({"TransformMatrix", "Rotation", "Orientation"}, axes * axes);
  const std::vector<double> spacings = read({"ElementSpacing", "ElementSize"}, axes);
  const std::vector<double> origin = read({"Offset", "Position", "Origin"}, axes);
  if (sizes.empty())
  {
    refuse("its header has no 'DimSize'");
  }
  ImagePlace place;
  place.space = ImageSpace::lps;
  place.unit = LengthUnit::millimetre; // as in ITK
  for (std::size_t axis = 0; axis < ofSpace; ++axis)
  {
    std::vector<double> step(axes);
    step[axis] = 1;
    if (!directions.empty())
    {
      const auto first = directions.begin() + static_cast<std::ptrdiff_t>(axis * axes);
      std::copy_n(first, axes, step.begin());
      checkStep(step);
    }
    place.dimensions[axis] = sizeOf(sizes[axis], "DimSize");
    place.origin[axis] = origin.empty() ? 0 : origin[axis];
    for (std::size_t row = 0; row < ofSpace; ++row)
    {
      place.steps[axis][row] = step[row] * (spacings.empty() ? 1 : spacings[axis]);
    }
  }
  return place;
}

/// Returns how many numbers the vectors of a NRRD have; 0 where it does not say.
std::size_t lengthOfVectors(const Fields& fields)
{
  if (const auto* text = findAny(fields, {"spacedimension"}))
  {
    return static_cast<std::size_t>(sizeOf(numberOf(*text, "space dimension"), "space dimension"));
  }
  const auto* const space = findAny(fields, {"space"});
  const std::string name = space ? inSmallLetters(*space) : "";
  const bool hasTime =
    name.size() >= 4 && (name.size() == 4 || name.substr(name.size() - 4) == "time");
  return !space ? 0 : hasTime ? 4 : 3;
}

/// Reads a vector as "(1,0,0)", of `length` numbers, or two to four if that is 0; nothing where
/// there is "none".
std::optional<std::vector<double>> vectorOf(
  std::string_view& text, const std::string& key, std::size_t length)
{
  text = trimmed(text);
  if (text.substr(0, 4) == "none")
  {
    text.remove_prefix(4);
    return {};
  }
  const std::size_t end = text.find(')');
  if (text.empty() || text.front() != '(' || end == std::string_view::npos)
  {
    refuse("its header has no vectors in '" + key + "'");
  }
  std::string words(text.substr(1, end - 1));
  const auto count = static_cast<std::size_t>(1 + std::count(words.begin(), words.end(), ','));
  std::replace(words.begin(), words.end(), ',', ' ');
  std::vector<double> numbers = numbersOf(words, key, length > 0 ? length : count);
  if (count < 2 || count > 4)
  {
    refuse("its header has vectors of " + std::to_string(count) + " numbers in '" + key + "'");
  }
  text.remove_prefix(end + 1);
  return numbers;
}

/// Reads a number for each of `axes` axes; nothing where there is NaN or no field.
std::vector<std::optional<double>> numbersOfAxes(
  const Fields& fields, const std::string& key, std::size_t axes)
{
  std::vector<std::optional<double>> numbers;
  const std::string* const text = findAny(fields, {nrrdName(key).c_str()});
  std::string_view rest = text ? std::string_view(*text) : std::string_view();
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
  {
    const bool isKnown = inSmallLetters(word) != "nan";
    numbers.push_back(isKnown ? std::optional(numberOf(word, key)) : std::nullopt);
  }
  checkCount(numbers.size(), key, text ? axes : 0);
  numbers.resize(axes);
  return numbers;
}

/// Reads for each of `axes` axes whether its ends are samples. They are the ends of cells
/// otherwise, half a step farther out, and where nothing is said, as in ITK.
std::vector<bool> endsAreSamples(const Fields& fields, std::size_t axes)
{
  std::vector<bool> areSamples;
  const std::string* const text = findAny(fields, {"centers", "centerings"});
  std::string_view rest = text ? std::string_view(*text) : std::string_view();
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
  {
    const std::string center = inSmallLetters(word);
    if (center != "node" && center != "cell" && center != "???" && center != "none")
    {
      refuse("its header has '" + std::string(word.substr(0, 20)) + "' in 'centers'");
    }
    areSamples.push_back(center == "node");
  }
  checkCount(areSamples.size(), "centers", text ? axes : 0);
  areSamples.resize(axes);
  return areSamples;
}

/// Reads for each of `axes` axes whether it is one of space by its kind. Others are of channels or
/// times.
std::vector<bool> axesOfSpace(const Fields& fields, std::size_t axes)
{
  std::vector<bool> areOfSpace;
  const std::string* const text = findAny(fields, {"kinds"});
  if (!text)
  {
    return std::vector<bool>(axes, true);
  }
  std::string_view rest = *text;
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
  {
    const std::string kind = inSmallLetters(word);
    areOfSpace.push_back(kind == "domain" || kind == "space" || kind == "???" || kind == "none");
  }
  checkCount(areOfSpace.size(), "kinds", axes);
  return areOfSpace;
}

/// Adds an axis of space with its number of voxels.
void addAxis(const std::array<double, 3>& step, double size, std::size_t& axis, ImagePlace& place)
{
  if (axis == 3)
  {
    refuse("its header has more than 3 axes of space");
  }
  place.steps[axis] = step;
  place.dimensions[axis++] = sizeOf(size, "sizes");
}

/// The numbers that say where axes lie without directions, for each of all axes.
struct Ends
{
  std::vector<std::optional<double>> spacings, mins, maxs;
  std::vector<bool> areSamples;
};

/// Reads the directions of the axes of space. Others have none, or go along time alone. Returns the
/// number of axes.
std::size_t addDirections(
  const Fields& fields, const std::vector<double>& sizes, const Ends& ends, ImagePlace& place)
{
  std::size_t axis = 0;
  std::string_view rest = fields.at("spacedirections");
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    const auto vector = vectorOf(rest, "space directions", lengthOfVectors(fields));
    if (!vector)
    {
      continue;
    }
    if (ends.spacings[n] || ends.mins[n] || ends.maxs[n])
    {
      refuse("its header has 'space directions' and 'spacings', 'axis mins' or 'axis maxs'");
    }
    std::array<double, 3> step = {};
    std::copy_n(vector->begin(), std::min<std::size_t>(vector->size(), 3), step.begin());
    if (vector->size() == 4 && vector->back() != 0 && step == std::array<double, 3>())
    {
      continue;
    }
    checkStep(*vector);
    addAxis(step, sizes[n], axis, place);
  }
  if (!trimmed(rest).empty())
  {
    refuse("its header has more vectors in 'space directions' than axes");
  }
  return axis;
}

/// Lays axes without directions along the ones of space, as ITK does: steps are 1 where there are
/// no spacings, whatever the ends of the axes say. Of more than three axes, `kinds` has to say
/// which are of space; the first three of these count, as in NIfTI. Returns the number of axes.
std::size_t addStraightAxes(
  const Fields& fields, const std::vector<double>& sizes, const Ends& ends, ImagePlace& place)
{
  std::size_t axis = 0;
  const bool haveKinds = findAny(fields, {"kinds"});
  const std::vector<bool> areOfSpace = axesOfSpace(fields, sizes.size());
  const bool haveMins = std::any_of(ends.mins.begin(), ends.mins.end(),
    [](const std::optional<double>& min) { return min.has_value(); });
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    if (!areOfSpace[n] || (haveKinds && axis == 3))
    {
      continue;
    }
    const auto& spacing = ends.spacings[n];
    const auto& min = ends.mins[n];
    const auto& max = ends.maxs[n];
    std::array<double, 3> step = {};
    step[std::min<std::size_t>(axis, 2)] = spacing.value_or(1);
    addAxis(step, sizes[n], axis, place);
    if (min ? !spacing && !max : haveMins || max)
    {
      refuse(min ? "its header has 'axis mins' and no 'spacings'"
                 : "its header has an axis without a number in 'axis mins'");
    }
    if (min)
    {
      const double width = spacing ? *spacing : (*max - *min) / sizes[n];
      place.origin[axis - 1] = *min + (ends.areSamples[n] ? 0 : width / 2);
    }
  }
  return axis;
}

/// Reads the axes of space, and where they begin.
void addAxes(const Fields& fields, const std::vector<double>& sizes, ImagePlace& place)
{
  const Ends ends = {numbersOfAxes(fields, "spacings", sizes.size()),
    numbersOfAxes(fields, "axis mins", sizes.size()),
    numbersOfAxes(fields, "axis maxs", sizes.size()), endsAreSamples(fields, sizes.size())};
  const std::string* const origin = findAny(fields, {"spaceorigin"});
  const std::size_t axes = findAny(fields, {"spacedirections"})
                             ? addDirections(fields, sizes, ends, place)
                             : addStraightAxes(fields, sizes, ends, place);
  if (axes < 2)
  {
    refuse("its header has fewer than 2 axes of space");
  }
  if (origin)
  {
    if (findAny(fields, {"axismins"}))
    {
      refuse("its header has 'space origin' and 'axis mins'");
    }
    std::string_view rest = *origin;
    if (const auto vector = vectorOf(rest, "space origin", lengthOfVectors(fields)))
    {
      std::copy_n(vector->begin(), std::min<std::size_t>(vector->size(), 3), place.origin.begin());
    }
  }
}

ImagePlace nrrdImage(const std::string& head)
{
  if (head.rfind("NRRD000", 0) != 0)
  {
    refuse("it does not begin like NRRD");
  }
  const Fields fields = nrrdFields(head);
  const std::string* const sizes = findAny(fields, {"sizes"});
  if (!sizes)
  {
    refuse("its header has no 'sizes'");
  }
  ImagePlace place;
  place.space = ImageSpace::lps; // as in ITK where none is named
  place.unit = LengthUnit::millimetre;
  if (const auto* name = findAny(fields, {"space"}))
  {
    const std::optional<ImageSpace> space = spaceOf(*name);
    if (!space)
    {
      refuse(
        "its header has a space '" + name->substr(0, 40) + "', which the format does not have");
    }
    place.space = *space;
  }
  addAxes(fields, numbersOf(*sizes, "sizes", axesOf(fields, "dimension")), place);
  return place;
}

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
  if (status != Z_OK)
  {
    throw Failure(EXIT_REFUSED, fileName,
      status == Z_BUF_ERROR ? "ends before it is unpacked; it is damaged, fetch it again"
                            : "cannot be unpacked; it is damaged, fetch it again");
  }
  beginning.resize(static_cast<std::size_t>(std::max(0, count)));
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
  double samples = 1, spacings[3], directions[9];
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::array<double, 3>& step = place.steps[static_cast<std::size_t>(axis)];
    const double spacing = std::hypot(step[0], step[1], step[2]);
    if (!(spacing > 0 && std::isfinite(spacing)))
    {
      refuse("its voxels have no size along an axis");
    }
    spacings[axis] = spacing;
    for (int row = 0; row < 3; ++row)
    {
      directions[3 * row + axis] = step[static_cast<std::size_t>(row)] / spacing;
    }
    samples *= place.dimensions[static_cast<std::size_t>(axis)];
  }
  constexpr double most = 1e15;
  if (samples > most)
  {
    refuse("its header counts more voxels than there can be");
  }
  image->SetDirectionMatrix(directions);
  constexpr double leastVolume = 1e-6;
  if (!(std::abs(image->GetDirectionMatrix()->Determinant()) > leastVolume))
  {
    refuse("its axes lie in a plane");
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
    return {imageAt(place), place.space, place.unit};
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
