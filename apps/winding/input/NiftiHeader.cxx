// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/NiftiHeader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace
{

/// Where the fields of the header stand. Each kind of NIfTI has its own numbers.
struct Layout
{
  std::size_t size, magic, dimensions, steps, units, qform, sform, quaternion, offset, rows;
  bool isWide; ///< whether numbers have 8 bytes, and codes 4
};

constexpr Layout layouts[] = {{348, 344, 40, 76, 123, 252, 254, 256, 268, 280, false},
  {540, 4, 16, 104, 500, 344, 348, 352, 376, 400, true}};

class Header
{
public:
  explicit Header(const std::string& bytes)
    : bytes_(bytes)
  {
    for (const Layout& layout : layouts)
    {
      for (const bool isSwapped : {false, true})
      {
        isSwapped_ = isSwapped;
        if (bytes.size() >= sizeof(std::int32_t) &&
            this->number<std::int32_t>(0) == static_cast<std::int32_t>(layout.size))
        {
          if (bytes.size() < layout.size)
          {
            throw HeaderFault("it ends before its header does");
          }
          layout_ = &layout;
          return;
        }
      }
    }
    throw HeaderFault("it does not begin like NIfTI");
  }

  const Layout& layout() const { return *layout_; }
  std::string magic() const { return bytes_.substr(layout_->magic, 3); }

  /// Number `n` of a field of whole numbers or codes, or of real ones.
  double whole(std::size_t field, std::size_t n) const
  {
    return layout_->isWide ? static_cast<double>(this->number<std::int64_t>(field + 8 * n))
                           : this->number<std::int16_t>(field + 2 * n);
  }
  int code(std::size_t field) const
  {
    return layout_->isWide ? this->number<std::int32_t>(field) : this->number<std::int16_t>(field);
  }
  LengthUnit unit() const
  {
    const int code = layout_->isWide ? this->number<std::int32_t>(layout_->units)
                                     : this->number<std::uint8_t>(layout_->units);
    const int ofLength = code & 7; // next to the unit of time
    return ofLength <= 3 ? static_cast<LengthUnit>(ofLength) : LengthUnit::unknown;
  }
  double raw(std::size_t field, std::size_t n) const
  {
    return layout_->isWide ? this->number<double>(field + 8 * n)
                           : static_cast<double>(this->number<float>(field + 4 * n));
  }
  /// The same, refused where it is not finite.
  double real(std::size_t field, std::size_t n) const
  {
    const double value = this->raw(field, n);
    if (!std::isfinite(value))
    {
      throw HeaderFault("its header has numbers that are not finite");
    }
    return value;
  }

private:
  template <class Number> Number number(std::size_t at) const
  {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, bytes_.data() + at, sizeof bytes);
    if (isSwapped_)
    {
      std::reverse(bytes, bytes + sizeof bytes);
    }
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
  }

  const std::string& bytes_;
  const Layout* layout_ = nullptr;
  bool isSwapped_ = false;
};

/// Returns the codes of both transforms, and the numbers of the qform.
NiftiForms formsOf(const Header& header)
{
  const Layout& layout = header.layout();
  NiftiForms forms;
  forms.qform = header.code(layout.qform);
  forms.sform = header.code(layout.sform);
  for (std::size_t n = 0; n < 4; ++n)
  {
    forms.steps[n] = header.raw(layout.steps, n);
    if (n < 3)
    {
      forms.quaternion[n] = header.raw(layout.quaternion, n);
      forms.offset[n] = header.raw(layout.offset, n);
    }
  }
  return forms;
}

/// Turns the axes as the quaternion (a, b, c, d) says; the header has its last three numbers.
void turn(const Header& header, ImagePlace& place)
{
  double b = header.real(header.layout().quaternion, 0);
  double c = header.real(header.layout().quaternion, 1);
  double d = header.real(header.layout().quaternion, 2);
  const double rest = 1 - (b * b + c * c + d * d);
  constexpr double least = 1e-7; // half a turn, up to rounding to single precision
  const double a = rest > least ? std::sqrt(rest) : 0;
  const double length = std::sqrt(a * a + b * b + c * c + d * d);
  b /= length;
  c /= length;
  d /= length;
  const double w = a / length;
  const double matrix[3][3] = {
    {w * w + b * b - c * c - d * d, 2 * (b * c - w * d), 2 * (b * d + w * c)},
    {2 * (b * c + w * d), w * w + c * c - b * b - d * d, 2 * (c * d - w * b)},
    {2 * (b * d - w * c), 2 * (c * d + w * b), w * w + d * d - c * c - b * b}};
  const double handed = header.real(header.layout().steps, 0) < 0 ? -1 : 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double step = place.steps[axis][axis] * (axis == 2 ? handed : 1);
    for (std::size_t row = 0; row < 3; ++row)
    {
      place.steps[axis][row] = matrix[row][axis] * step;
    }
  }
}

} // namespace

ImagePlace niftiImage(const std::string& head)
{
  const Header header(head);
  const Layout& layout = header.layout();
  const std::string magic = header.magic();
  if (magic != "n+1" && magic != "ni1" && magic != "n+2" && magic != "ni2")
  {
    throw HeaderFault("its header is Analyze's, which says no directions");
  }
  ImagePlace place;
  place.space = ImageSpace::ras;
  place.unit = header.unit();
  place.forms = formsOf(header);
  const double axes = header.whole(layout.dimensions, 0);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double count =
      axes > static_cast<double>(axis) ? header.whole(layout.dimensions, axis + 1) : 1;
    if (!(axes >= 1 && axes <= 7 && count >= 1 && count <= std::numeric_limits<int>::max()))
    {
      throw HeaderFault("its header has no number of voxels along an axis");
    }
    place.dimensions[axis] = static_cast<int>(count);
  }
  if (header.code(layout.sform) > 0)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        place.steps[axis][row] = header.real(layout.rows, 4 * row + axis);
      }
      place.origin[row] = header.real(layout.rows, 4 * row + 3);
    }
  }
  else
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      place.steps[axis][axis] = header.real(layout.steps, axis + 1);
    }
  }
  if (header.code(layout.sform) <= 0 && header.code(layout.qform) > 0)
  {
    turn(header, place);
    for (std::size_t row = 0; row < 3; ++row)
    {
      place.origin[row] = header.real(layout.offset, row);
    }
  }
  return place;
}
