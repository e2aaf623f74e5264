#include "FieldOutput.h"

#include <algorithm>

namespace winding
{

template <class Real>
void FieldOutput::write(const Real* from, std::size_t first, std::size_t count) const
{
  if (this->values)
  {
    std::transform(from, from + count, this->values + first,
      [](Real value) { return static_cast<float>(value); });
  }
  if (this->doubleValues)
  {
    std::copy_n(from, count, this->doubleValues + first);
  }
  if (this->inside)
  {
    std::transform(from, from + count, this->inside + first,
      [this](Real value)
      {
        const double stored = this->doubleValues ? value : static_cast<float>(value);
        return static_cast<unsigned char>(isInside(stored, this->rule, this->threshold));
      });
  }
}

template void FieldOutput::write(const float*, std::size_t, std::size_t) const;
template void FieldOutput::write(const double*, std::size_t, std::size_t) const;

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
