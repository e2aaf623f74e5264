#include "FieldOutput.h"

#include <algorithm>

namespace winding
{

void FieldOutput::write(const double* from, std::size_t first, std::size_t count) const
{
  if (this->values)
  {
    std::transform(from, from + count, this->values + first,
      [](double value) { return static_cast<float>(value); });
  }
  if (this->doubleValues)
  {
    std::copy_n(from, count, this->doubleValues + first);
  }
  if (this->inside)
  {
    std::transform(from, from + count, this->inside + first,
      [this](double value)
      {
        const double stored = this->doubleValues ? value : static_cast<float>(value);
        return static_cast<unsigned char>(isInside(stored, this->rule, this->threshold));
      });
  }
}

void FieldOutput::fill(double value, std::size_t first, std::size_t count) const
{
  if (this->values)
  {
    std::fill_n(this->values + first, count, static_cast<float>(value));
  }
  if (this->doubleValues)
  {
    std::fill_n(this->doubleValues + first, count, value);
  }
  if (this->inside)
  {
    const double stored = this->doubleValues ? value : static_cast<float>(value);
    std::fill_n(this->inside + first, count,
      static_cast<unsigned char>(isInside(stored, this->rule, this->threshold)));
  }
}

} // namespace winding
