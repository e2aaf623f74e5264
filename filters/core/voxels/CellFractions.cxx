#include "voxels/CellFractions.h"

#include "base/Bounds.h"
#include "base/Progress.h"
#include "source/BoxTree.h"
#include "source/CoordinateOrder.h"
#include "surface/Boundary.h"
#include "voxels/ConeShare.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace winding
{

namespace
{

/// Cells of less than this part of the cube of their box's diagonal have no volume.
constexpr double leastVolume = 1e-13;

/// Faces are planar whose corners give tetrahedra of less than this part of that cube.
constexpr double leastWarp = 1e-10;

/// How often cones are divided into eight where w changes off triangles.
constexpr int divisions = 2;

/// The cells that are divided at a time, which limits the memory of their parts.
constexpr std::size_t cellsAtOnce = 2048;

/// Cells where w changes off triangles are divided where what decides is nearer to its limit than
/// this: across a cell that no triangle and no boundary edge meets w changes by less.
constexpr double nearLimit = 0.35;

enum class State : unsigned char
{
  clear,   ///< nothing of the source is near
  touched, ///< a triangle's box meets the cell's box, or a point is near it
  onRim,   ///< so does an edge of the boundary, around which w takes all values
  flat,
  nowhere
};

/// A cell in coordinates of its own: from its first point, in units of its box's diagonal.
class LocalCell
{
public:
  /// Returns what kind of cell it is, `clear` if it has a volume.
  State set(const CellShape& shape)
  {
    box_.setEmpty();
    bool isFinite = !shape.points.empty();
    for (const Eigen::Vector3d& point : shape.points)
    {
      isFinite = isFinite && point.allFinite();
      box_.extend(point);
    }
    origin_ = isFinite ? shape.points[0] : Eigen::Vector3d::Zero();
    size_ = isFinite ? box_.sizes().stableNorm() : 0;
    if (!isFinite || !std::isfinite(size_))
    {
      return State::nowhere;
    }
    points_.clear();
    triangles_.clear();
    middle_.setZero();
    for (const Eigen::Vector3d& point : shape.points)
    {
      points_.push_back(size_ > 0 ? this->local(point) : Eigen::Vector3d::Zero());
      middle_ += points_.back();
    }
    middle_ /= static_cast<double>(points_.size());
    corners_ = points_.size();
    for (std::size_t face = 0; face < shape.faces(); ++face)
    {
      this->addFace(shape.faceCorners.data() + shape.faceEnds[face],
        std::size_t(shape.faceEnds[face + 1] - shape.faceEnds[face]));
    }
    volume_ = 0;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
    {
      volume_ += this->cone(i, middle_).determinant();
    }
    return std::abs(volume_) > 6 * leastVolume ? State::clear : State::flat;
  }

  Eigen::Vector3d local(const Eigen::Vector3d& position) const
  {
    return (position - origin_) / size_;
  }
  Eigen::Vector3d global(const Eigen::Vector3d& position) const
  {
    return origin_ + size_ * position;
  }

  const Bounds& box() const { return box_; }
  const Eigen::Vector3d& middle() const { return middle_; }

  /// Six times the volume, negative for cells that are turned inside out.
  double volume() const { return volume_; }

  std::size_t cones() const { return triangles_.size(); }

  /// The corners of a triangle of the faces, relative to an apex, as columns.
  Eigen::Matrix3d cone(std::size_t triangle, const Eigen::Vector3d& apex) const
  {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i)
    {
      corners.col(i) = points_[triangles_[triangle][std::size_t(i)]] - apex;
    }
    return corners;
  }

  std::size_t corners() const { return corners_; }
  const Eigen::Vector3d& corner(std::size_t i) const { return points_[i]; }

private:
  bool isPlanar(const int* corners, std::size_t count) const
  {
    const auto at = [&](std::size_t i) -> const Eigen::Vector3d&
    {
      return points_[std::size_t(corners[i])];
    };
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 2; i < count; ++i)
    {
      normal += (at(i - 1) - at(0)).cross(at(i) - at(0));
    }
    for (std::size_t i = 1; i < count; ++i)
    {
      if (std::abs(normal.dot(at(i) - at(0))) > leastWarp)
      {
        return false;
      }
    }
    return true;
  }

  void addFace(const int* corners, std::size_t count)
  {
    const auto id = [corners](std::size_t i)
    {
      return static_cast<std::size_t>(corners[i]);
    };
    if (count == 3 || this->isPlanar(corners, count))
    {
      for (std::size_t i = 2; i < count; ++i)
      {
        triangles_.push_back({id(0), id(i - 1), id(i)});
      }
      return;
    }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < count; ++i)
    {
      mean += points_[id(i)];
    }
    points_.push_back(mean / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
    {
      triangles_.push_back({points_.size() - 1, id(i), id(i + 1 < count ? i + 1 : 0)});
    }
  }

  Bounds box_;
  Eigen::Vector3d origin_, middle_;
  double size_ = 0, volume_ = 0;
  std::size_t corners_ = 0;
  std::vector<Eigen::Vector3d> points_; ///< corners, and the means of faces
  std::vector<std::array<std::size_t, 3>> triangles_;
};

/// A part of a cell that is divided, a tetrahedron in the cell's coordinates.
struct Part
{
  std::array<Eigen::Vector3d, 4> corners;
  std::uint32_t cell; ///< its number among those divided at a time
  double volume;      ///< six times the volume, signed
  State state;        ///< clear, touched or onRim, by triangles only

  /// A point without a pattern, so that it lies on no triangle where meshes are regular.
  Eigen::Vector3d apex() const
  {
    return 0.2437 * corners[0] + 0.2561 * corners[1] + 0.2389 * corners[2] + 0.2613 * corners[3];
  }
};

double squaredDistance(const ConeTriangle& triangle)
{
  const auto& [a, b, c] = triangle.corners;
  const auto ofSide = [](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  {
    const Eigen::Vector3d side = to - from;
    const double squared = side.squaredNorm();
    const double at = squared > 0 ? std::clamp(-from.dot(side) / squared, 0.0, 1.0) : 0;
    return (from + at * side).squaredNorm();
  };
  const double nearest = std::min({ofSide(a, b), ofSide(b, c), ofSide(c, a)});
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const bool isAbove =
    normal.dot(a.cross(b)) > 0 && normal.dot(b.cross(c)) > 0 && normal.dot(c.cross(a)) > 0;
  return isAbove ? std::min(nearest, std::pow(normal.normalized().dot(a), 2)) : nearest;
}

/// A part of a volume, without what rounding adds, and not −0.
float shareOf(double inside, double volume)
{
  return static_cast<float>(std::clamp(inside / volume, 0.0, 1.0) + 0.0);
}

/// The part of a tetrahedron where a linear function is positive, from its values at the corners.
double positivePart(std::array<double, 4> values)
{
  std::sort(values.begin(), values.end());
  const auto cornerPart = [&values](std::size_t corner)
  {
    double part = 1;
    for (std::size_t i = 0; i < 4; ++i)
    {
      part *= i == corner ? 1 : values[corner] / (values[corner] - values[i]);
    }
    return part;
  };
  if (values[0] >= 0)
  {
    return 1;
  }
  if (values[3] <= 0)
  {
    return 0;
  }
  if (values[1] >= 0)
  {
    return 1 - cornerPart(0);
  }
  if (values[2] <= 0)
  {
    return cornerPart(3);
  }
  // Two corners on either side: a prism, cut into three tetrahedra (a, b negative, c, d positive).
  const auto [a, b, c, d] = values;
  const double ac = c / (c - a), ad = d / (d - a), bc = c / (c - b), bd = d / (d - b);
  return ac * bc * (1 - bd) + bd * (ac * (1 - ad) + ad);
}

class Evaluation
{
public:
  Evaluation(const Field& field, const CellShapes& cells, InsideRule rule, double threshold,
    Executor& executor)
    : field_(field)
    , cells_(cells)
    , rule_(rule)
    , threshold_(threshold)
    , executor_(executor)
    , surface_(field.distinctSurface())
  {
    if (surface_)
    {
      tree_ = std::make_unique<BoxTree>(*surface_, executor);
      if (!field.info().jumpsOnly())
      {
        this->makeRims();
      }
    }
    else if (field.cloud())
    {
      tree_ = std::make_unique<BoxTree>(*field.cloud(), executor);
    }
  }

  CellsWithoutFraction run(float* fractions)
  {
    Progress progress(executor_);
    progress.set(0, 0.3);
    this->findApexes();
    progress.set(0.3, 0.6);
    windings_.resize(cells_.size());
    this->evaluate(apexes_, windings_);
    progress.set(0.6, 1);
    std::vector<std::size_t> touched, divided;
    CellsWithoutFraction counts;
    for (std::size_t i = 0; i < cells_.size(); ++i)
    {
      const State state = states_[i];
      counts.flat += state == State::flat;
      counts.nowhere += state == State::nowhere;
      fractions[i] = state == State::nowhere ? std::numeric_limits<float>::quiet_NaN()
                     : isInside(windings_[i], rule_, threshold_) ? 1.0F
                                                                 : 0.0F;
      if (this->isDivided(i))
      {
        divided.push_back(i);
      }
      else if (state == State::touched && surface_)
      {
        touched.push_back(i);
      }
    }
    const double share =
      static_cast<double>(touched.size()) /
      static_cast<double>(std::max<std::size_t>(1, touched.size() + 100 * divided.size()));
    progress.set(0.6, 0.6 + 0.4 * share);
    constexpr std::size_t cellsPerBlock = 64;
    executor_.run((touched.size() + cellsPerBlock - 1) / cellsPerBlock,
      [&](std::size_t block)
      {
        Work work(*this);
        const std::size_t first = block * cellsPerBlock;
        for (std::size_t i = first; i < std::min(touched.size(), first + cellsPerBlock); ++i)
        {
          fractions[touched[i]] = this->fractionOf(touched[i], work);
        }
      });
    for (std::size_t first = 0; first < divided.size(); first += cellsAtOnce)
    {
      const std::size_t last = std::min(divided.size(), first + cellsAtOnce);
      const auto at = [&](std::size_t done)
      {
        return 0.6 + 0.4 * (share + (1 - share) * static_cast<double>(done) /
                                      static_cast<double>(divided.size()));
      };
      progress.set(at(first), at(last));
      this->divide(divided.data() + first, last - first, fractions);
    }
    return counts;
  }

private:
  /// Memory that a thread takes for all of its cells.
  struct Work
  {
    explicit Work(const Evaluation& of)
      : share(of.rule_, of.threshold_, of.field_.info().method == Method::parity)
    {
    }
    CellShape shape;
    LocalCell cell;
    std::vector<ConeTriangle> triangles, moved;
    ConeShare share;
  };

  /// Makes the tree of the boundary's edges, as triangles without area.
  void makeRims()
  {
    rims_.vertices = surface_->vertices;
    for (const BoundaryEdge& edge : boundaryChain(*surface_, executor_).edges)
    {
      rims_.triangles.push_back({edge.from, edge.to, edge.to});
    }
    rimTree_ = std::make_unique<BoxTree>(rims_, executor_);
  }

  State load(std::size_t number, Work& work) const
  {
    work.shape.clear();
    cells_.get(number, work.shape);
    return work.cell.set(work.shape);
  }

  /// Sets the triangles whose boxes meet a box, in the coordinates of a cell.
  void setTriangles(const LocalCell& cell, const Bounds& box, std::vector<ConeTriangle>& to) const
  {
    to.clear();
    const ChainView chain(*surface_);
    tree_->forEachIn(box,
      [&](std::uint32_t number)
      {
        const Triangle ids = lowestFirst(surface_->vertices, chain[number]);
        ConeTriangle triangle;
        for (std::size_t i = 0; i < 3; ++i)
        {
          triangle.corners[i] = cell.local(surface_->vertices[std::size_t(ids[i])]);
          triangle.ids[i] = ids[i];
        }
        triangle.multiplicity = chain.multiplicity(number);
        if (triangle.multiplicity != 0)
        {
          to.push_back(triangle);
        }
        return true;
      });
  }

  static void move(const std::vector<ConeTriangle>& from, const Eigen::Vector3d& apex,
    std::vector<ConeTriangle>& to)
  {
    to = from;
    for (ConeTriangle& triangle : to)
    {
      for (Eigen::Vector3d& corner : triangle.corners)
      {
        corner -= apex;
      }
    }
  }

  /// Returns a point of a cell that lies off the triangles, in its coordinates: the first of some
  /// that is far enough, or the farthest.
  static Eigen::Vector3d apexOf(const LocalCell& cell, const std::vector<ConeTriangle>& triangles)
  {
    constexpr double farEnough = 1e-2, golden = 0.6180339887498949;
    constexpr std::size_t tries = 24;
    // A cell with a volume has four corners or more. Weights without a pattern keep the apex out of
    // planes of triangles, which it would not see, where meshes are regular.
    const Eigen::Vector3d start = cell.middle() + 0.1137 * (cell.corner(0) - cell.middle()) +
                                  0.0519 * (cell.corner(1) - cell.middle()) +
                                  0.0213 * (cell.corner(2) - cell.middle());
    Eigen::Vector3d best = start;
    double bestSquared = -1;
    for (std::size_t i = 0; i < tries && bestSquared < farEnough * farEnough; ++i)
    {
      const double step = i == 0 ? 0 : 0.1 + 0.6 * std::fmod(golden * static_cast<double>(i), 1.0);
      const Eigen::Vector3d at = start + step * (cell.corner(i % cell.corners()) - start);
      double squared = std::numeric_limits<double>::infinity();
      for (const ConeTriangle& triangle : triangles)
      {
        ConeTriangle moved = triangle;
        for (Eigen::Vector3d& corner : moved.corners)
        {
          corner -= at;
        }
        squared = std::min(squared, squaredDistance(moved));
        if (squared <= bestSquared)
        {
          break;
        }
      }
      if (squared > bestSquared)
      {
        bestSquared = squared;
        best = at;
      }
    }
    return best;
  }

  void findApexes()
  {
    apexes_.resize(cells_.size());
    states_.resize(cells_.size());
    constexpr std::size_t cellsPerBlock = 1024;
    executor_.run((cells_.size() + cellsPerBlock - 1) / cellsPerBlock,
      [&](std::size_t block)
      {
        Work work(*this);
        const std::size_t first = block * cellsPerBlock;
        for (std::size_t i = first; i < std::min(cells_.size(), first + cellsPerBlock); ++i)
        {
          State state = this->load(i, work);
          Eigen::Vector3d apex = work.cell.middle();
          if (state == State::nowhere)
          {
            apexes_[i].setConstant(std::numeric_limits<double>::quiet_NaN());
            states_[i] = state;
            continue;
          }
          if (state == State::clear && tree_ && tree_->reaches(this->reachOf(work.cell)))
          {
            state = rimTree_ && rimTree_->reaches(work.cell.box()) ? State::onRim : State::touched;
            if (surface_)
            {
              this->setTriangles(work.cell, work.cell.box(), work.triangles);
              apex = apexOf(work.cell, work.triangles);
            }
          }
          apexes_[i] = work.cell.global(apex);
          states_[i] = state;
        }
      });
  }

  /// The box in which something of the source makes a cell touched. w has no bound near points,
  /// and changes by any amount across cells next to them.
  Bounds reachOf(const LocalCell& cell) const
  {
    const Eigen::Vector3d margin =
      Eigen::Vector3d::Constant(surface_ ? 0 : cell.box().sizes().norm());
    return {cell.box().min() - margin, cell.box().max() + margin};
  }

  void evaluate(const std::vector<Eigen::Vector3d>& samples, std::vector<double>& windings)
  {
    FieldOutput output;
    output.doubleValues = windings.data();
    field_.evaluate(VectorsView(samples.empty() ? nullptr : samples[0].data(), samples.size()),
      output, executor_);
  }

  /// Whether what decides is near its limit, at w or beyond a triangle.
  bool isNearLimit(double winding, bool isMet) const
  {
    for (const int step : {0, 1, -1, 2, -2})
    {
      const double level = levelOf(winding + step, rule_, threshold_);
      if (!(std::abs(level) > nearLimit))
      {
        return true;
      }
      if (!isMet)
      {
        return false;
      }
    }
    return false;
  }

  bool isDivided(std::size_t cell) const
  {
    const State state = states_[cell];
    if (field_.info().jumpsOnly() || state == State::flat || state == State::nowhere)
    {
      return false;
    }
    return state == State::onRim || (state == State::touched && !surface_) ||
           this->isNearLimit(windings_[cell], state == State::touched);
  }

  /// Returns the share of a cell that triangles meet, w at its apex being known.
  float fractionOf(std::size_t number, Work& work) const
  {
    this->load(number, work);
    this->setTriangles(work.cell, work.cell.box(), work.triangles);
    const Eigen::Vector3d apex = work.cell.local(apexes_[number]);
    move(work.triangles, apex, work.moved);
    double inside = 0, volume = 0;
    for (std::size_t i = 0; i < work.cell.cones(); ++i)
    {
      const Eigen::Matrix3d corners = work.cell.cone(i, apex);
      const double ofCone = corners.determinant();
      if (ofCone != 0)
      {
        volume += ofCone;
        inside += ofCone * work.share.of(corners, work.moved, windings_[number]);
      }
    }
    return shareOf(inside, volume);
  }

  /// Returns the share of a part that triangles meet, w at its apex being known.
  double shareOfPart(const Part& part, double winding, const LocalCell& cell, Work& work) const
  {
    this->setTriangles(cell, boxOf(part, cell), work.triangles);
    const Eigen::Vector3d apex = part.apex();
    move(work.triangles, apex, work.moved);
    double inside = 0, volume = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      // The corners but one, in the order that leaves the part its sign.
      Eigen::Matrix3d corners;
      corners.col(0) = part.corners[(i + 1) % 4] - apex;
      corners.col(1) = part.corners[(i + 2) % 4] - apex;
      corners.col(2) = part.corners[(i + 3) % 4] - apex;
      const double ofCone = std::abs(corners.determinant());
      if (ofCone > 0)
      {
        volume += ofCone;
        inside += ofCone * work.share.of(corners, work.moved, winding);
      }
    }
    return volume > 0 ? inside / volume : 0;
  }

  static Bounds boxOf(const Part& part, const LocalCell& cell)
  {
    Bounds box;
    for (const Eigen::Vector3d& corner : part.corners)
    {
      box.extend(cell.global(corner));
    }
    return box;
  }

  /// Divides cells where w changes off triangles, and adds up what is inside of their parts.
  void divide(const std::size_t* numbers, std::size_t count, float* fractions)
  {
    std::vector<LocalCell> locals(count);
    std::vector<Part> parts, next;
    Work work(*this);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->load(numbers[i], work);
      locals[i] = work.cell;
      for (std::size_t j = 0; j < work.cell.cones(); ++j)
      {
        const Eigen::Matrix3d corners = work.cell.cone(j, work.cell.middle());
        Part part = {};
        part.corners[0] = work.cell.middle();
        for (int k = 0; k < 3; ++k)
        {
          part.corners[std::size_t(k) + 1] = work.cell.middle() + corners.col(k);
        }
        part.cell = static_cast<std::uint32_t>(i);
        part.volume = corners.determinant();
        parts.push_back(part);
      }
    }
    std::vector<double> inside(count, 0.0);
    for (int division = 0; !parts.empty(); ++division)
    {
      std::vector<double> shares(parts.size());
      this->findShares(locals, parts, division == divisions, shares);
      next.clear();
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        if (std::isnan(shares[i]))
        {
          addEighths(parts[i], next);
        }
        else
        {
          inside[parts[i].cell] += parts[i].volume * shares[i];
        }
      }
      parts.swap(next);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      fractions[numbers[i]] = shareOf(inside[i], locals[i].volume());
    }
  }

  /// Sets the shares of parts, NaN for those to be divided further; `isLast` leaves none of these.
  void findShares(const std::vector<LocalCell>& locals, std::vector<Part>& parts, bool isLast,
    std::vector<double>& shares)
  {
    forEachItem(
      parts.size(),
      [&](std::size_t i)
      {
        const Bounds box = boxOf(parts[i], locals[parts[i].cell]);
        parts[i].state = !surface_ || !tree_->reaches(box) ? State::clear
                         : rimTree_->reaches(box)          ? State::onRim
                                                           : State::touched;
      },
      executor_);
    std::vector<Eigen::Vector3d> samples;
    for (const Part& part : parts)
    {
      const LocalCell& cell = locals[part.cell];
      samples.push_back(cell.global(part.apex()));
      for (std::size_t i = 0; part.state == State::clear && i < 4; ++i)
      {
        samples.push_back(cell.global(part.corners[i]));
      }
    }
    std::vector<double> windings(samples.size());
    this->evaluate(samples, windings);
    std::vector<std::size_t> firsts;
    std::size_t first = 0;
    for (const Part& part : parts)
    {
      firsts.push_back(first);
      first += part.state == State::clear ? 5 : 1;
    }
    constexpr std::size_t partsPerBlock = 512;
    runBlocks(
      parts.size(), partsPerBlock,
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        Work work(*this);
        for (std::size_t i = begin; i < end; ++i)
        {
          const double* const ofPart = windings.data() + firsts[i];
          const State state = parts[i].state;
          const bool isNear =
            state == State::onRim ||
            (state == State::touched ? this->isNearLimit(ofPart[0], true) : this->mayPass(ofPart));
          shares[i] = isNear && !isLast ? std::numeric_limits<double>::quiet_NaN()
                      : state == State::clear
                        ? this->linearShare(ofPart)
                        : this->shareOfPart(parts[i], ofPart[0], locals[parts[i].cell], work);
        }
      },
      executor_);
  }

  /// Whether the level may pass a part, from w at its apex and its corners.
  bool mayPass(const double* windings) const
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < 5; ++i)
    {
      const double level = levelOf(windings[i], rule_, threshold_);
      low = std::min(low, level);
      high = std::max(high, level);
    }
    const double spread = high - low;
    return !(low - spread / 2 > 0 || high + spread / 2 < 0);
  }

  double linearShare(const double* windings) const
  {
    std::array<double, 4> levels;
    for (std::size_t i = 0; i < 4; ++i)
    {
      levels[i] = levelOf(windings[i + 1], rule_, threshold_);
    }
    return positivePart(levels);
  }

  /// Adds the eight parts that the middles of the sides make (Bey, Computing 55, 1995).
  static void addEighths(const Part& part, std::vector<Part>& to)
  {
    const auto& v = part.corners;
    const auto mid = [&v](std::size_t i, std::size_t j) -> Eigen::Vector3d
    {
      return 0.5 * (v[i] + v[j]);
    };
    const Eigen::Vector3d m01 = mid(0, 1), m02 = mid(0, 2), m03 = mid(0, 3), m12 = mid(1, 2),
                          m13 = mid(1, 3), m23 = mid(2, 3);
    const std::array<std::array<Eigen::Vector3d, 4>, 8> eighths = {
      {{v[0], m01, m02, m03}, {m01, v[1], m12, m13}, {m02, m12, v[2], m23}, {m03, m13, m23, v[3]},
        {m01, m02, m03, m13}, {m01, m02, m12, m13}, {m02, m03, m13, m23}, {m02, m12, m13, m23}}};
    for (const std::array<Eigen::Vector3d, 4>& corners : eighths)
    {
      to.push_back({corners, part.cell, part.volume / 8, State::clear});
    }
  }

  const Field& field_;
  const CellShapes& cells_;
  const InsideRule rule_;
  const double threshold_;
  Executor& executor_;
  const Surface* const surface_;
  std::unique_ptr<const BoxTree> tree_, rimTree_;
  Surface rims_; ///< edges of the boundary
  std::vector<Eigen::Vector3d> apexes_;
  std::vector<State> states_;
  std::vector<double> windings_;
};

} // namespace

CellsWithoutFraction evaluateFractions(const Field& field, const CellShapes& cells, InsideRule rule,
  double threshold, float* fractions, Executor& executor)
{
  return Evaluation(field, cells, rule, threshold, executor).run(fractions);
}

std::vector<Message> warningsOf(const CellsWithoutFraction& counts, std::size_t cells)
{
  std::vector<Message> messages;
  const auto add = [&](std::size_t count, const char* what, const char* fact)
  {
    if (count > 0)
    {
      messages.emplace_back(
        std::to_string(count) + " of " + std::to_string(cells) + " cells " + what,
        std::vector<Remedy>(), fact);
    }
  };
  add(counts.flat, "have no volume", "their fraction is 1 or 0, as their middle is inside or not");
  add(counts.nowhere, "are empty or not finite", "they have no fraction");
  return messages;
}

std::size_t bytesOfCellFractions(const Field& field, std::size_t cells)
{
  const std::size_t primitives = field.info().primitives;
  const bool isDivided = !field.info().jumpsOnly();
  // Cones, less than half of their eighths, and as many of theirs; each has five samples.
  constexpr std::size_t ofParts = cellsAtOnce * 200 * (sizeof(Part) + 5 * 32);
  constexpr std::size_t perCell =
    sizeof(Eigen::Vector3d) + sizeof(double) + sizeof(State) + sizeof(std::size_t);
  return BoxTree::bytesFor(primitives) +
         field.info().netBoundaryEdges * (sizeof(Triangle) + BoxTree::bytesFor(1)) +
         (isDivided ? primitives / 2 * sizeof(Eigen::Vector3d) : 0) + cells * perCell +
         (isDivided ? ofParts : 0);
}

} // namespace winding
