#include "Predicates.h"

#include <cmath>

// Notation: u, v are the two coordinates. The terms below are exact pairs (value, rounding error);
// this needs -ffp-contract=off, which the whole core is compiled with.

namespace winding
{

namespace
{

int signOf(double value)
{
  return (value > 0) - (value < 0);
}

/// A sum of doubles kept exactly, as non-overlapping components of increasing magnitude.
template <int Capacity> class Expansion
{
public:
  void add(double term)
  {
    int kept = 0;
    for (int i = 0; i < size_; ++i)
    {
      const double sum = term + components_[i];
      const double shadow = sum - term;
      const double error = (term - (sum - shadow)) + (components_[i] - shadow);
      if (error != 0)
      {
        components_[kept++] = error;
      }
      term = sum;
    }
    if (term != 0)
    {
      components_[kept++] = term;
    }
    size_ = kept;
  }

  void addProduct(double a, double b)
  {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  void addProduct(double a, double b, double c)
  {
    const double product = a * b;
    addProduct(std::fma(a, b, -product), c);
    addProduct(product, c);
  }

  int sign() const { return size_ == 0 ? 0 : signOf(components_[size_ - 1]); }

private:
  double components_[Capacity];
  int size_ = 0;
};

/// a − b = value + error, exactly.
struct ExactDifference
{
  ExactDifference(double a, double b)
    : value(a - b)
  {
    const double shadow = a - value;
    error = (a - (value + shadow)) + (shadow - b);
  }
  double value, error;
};

void addProduct(Expansion<16>& sum, const ExactDifference& a, const ExactDifference& b, double sign)
{
  sum.addProduct(sign * a.error, b.error);
  sum.addProduct(sign * a.error, b.value);
  sum.addProduct(sign * a.value, b.error);
  sum.addProduct(sign * a.value, b.value);
}

int exactSide(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& q)
{
  Expansion<16> sum;
  addProduct(sum, {to[0], from[0]}, {q[1], from[1]}, 1);
  addProduct(sum, {to[1], from[1]}, {q[0], from[0]}, -1);
  return sum.sign();
}

int exactSide(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& q)
{
  // Six products of three differences of two doubles each, four components a product of doubles.
  Expansion<192> sum;
  const auto addTerm =
    [&](const ExactDifference& x, const ExactDifference& y, const ExactDifference& z, double sign)
  {
    for (const double u : {x.error, x.value})
    {
      for (const double v : {y.error, y.value})
      {
        sum.addProduct(sign * u, v, z.error);
        sum.addProduct(sign * u, v, z.value);
      }
    }
  };
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    addTerm({a[i], q[i]}, {b[j], q[j]}, {c[k], q[k]}, 1);
    addTerm({a[i], q[i]}, {b[k], q[k]}, {c[j], q[j]}, -1);
  }
  return sum.sign();
}

} // namespace

int sideOfEdge(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& q)
{
  const double left = (to[0] - from[0]) * (q[1] - from[1]);
  const double right = (to[1] - from[1]) * (q[0] - from[0]);
  const double area = left - right;
  // Each difference, product and the last subtraction round once: (3 + 16ε)ε with ε = 2^−53.
  constexpr double errorBound = 3.3306690738754716e-16;
  if (std::abs(area) > errorBound * (std::abs(left) + std::abs(right)))
  {
    return signOf(area);
  }
  const int side = exactSide(from, to, q);
  if (side != 0)
  {
    return side;
  }
  // On the line: what the infinitesimal steps of q add, −(to − from)_v along u, (to − from)_u along
  // v.
  const int alongU = (from[1] > to[1]) - (from[1] < to[1]);
  return alongU != 0 ? alongU : (to[0] > from[0]) - (to[0] < from[0]);
}

int sideOfPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& q)
{
  const Eigen::Vector3d x = a - q, y = b - q, z = c - q;
  double volume = 0, size = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double left = y[j] * z[k], right = y[k] * z[j];
    volume += x[i] * (left - right);
    size += std::abs(x[i]) * (std::abs(left) + std::abs(right));
  }
  // (7 + 56ε)ε with ε = 2^−53, as Shewchuk's orient3d.
  constexpr double errorBound = 7.7715611723761027e-16;
  return std::abs(volume) > errorBound * size ? signOf(volume) : exactSide(a, b, c, q);
}

} // namespace winding
