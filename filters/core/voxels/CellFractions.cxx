// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/CellFractions.h"

#include "base/Progress.h"
#include "source/BoxTree.h"
#include "source/CoordinateOrder.h"
#include "surface/Boundary.h"
#include "voxels/CellParts.h"
#include "voxels/ConeShare.h"
#include "voxels/LocalCell.h"

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

/// How often cones are divided into eight where w changes off triangles.
constexpr int divisions = 2;

/// The cells that are divided at a time, which limits the memory of their parts.
constexpr std::size_t cellsAtOnce = 2048;

/// Cells where w changes off triangles are divided where what decides is nearer to its limit than
/// this: across a cell that no triangle and no boundary edge meets w changes by less.
constexpr double nearLimit = 0.35;

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

/// Returns the share of a volume. It is exactly 0 or 1 where it differs from these by rounding
/// alone, 1e-12 of the volume.
float shareOf(double inside, double volume)
{
  constexpr double rounding = 1e-12;
  const double share = inside / volume;
  return share < rounding ? 0.0F : share > 1 - rounding ? 1.0F : static_cast<float>(share);
}

/// Whether a cell bounds no volume, so that it has no fraction.
bool isWithoutFraction(CellState state)
{
  return state == CellState::nowhere || state == CellState::open;
}

class Evaluation
{
public:
  Evaluation(
    const Field& field, const CellShapes& cells, const InsideTest& isInside, Executor& executor)
    : field_(field)
    , cells_(cells)
    , isInside_(isInside)
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
      const CellState state = states_[i];
      counts.flat += state == CellState::flat;
      counts.open += state == CellState::open;
      counts.nowhere += state == CellState::nowhere;
      counts.curved += isStraightened_[i] != 0;
      fractions[i] = isWithoutFraction(state)  ? std::numeric_limits<float>::quiet_NaN()
                     : isInside_(windings_[i]) ? 1.0F
                                               : 0.0F;
      if (this->isDivided(i))
      {
        divided.push_back(i);
      }
      else if (state == CellState::touched && surface_)
      {
        touched.push_back(i);
      }
    }
    const double share =
      static_cast<double>(touched.size()) /
      static_cast<double>(std::max<std::size_t>(1, touched.size() + 100 * divided.size()));
    progress.set(0.6, 0.6 + 0.4 * share);
    // Few cells may have many triangles each.
    const std::size_t cellsPerBlock = std::clamp<std::size_t>(touched.size() / 256, 1, 64);
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
      : share(of.isInside_, of.field_.info().method == Method::parity)
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

  CellState load(std::size_t number, Work& work) const
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
    isStraightened_.resize(cells_.size());
    constexpr std::size_t cellsPerBlock = 1024;
    executor_.run((cells_.size() + cellsPerBlock - 1) / cellsPerBlock,
      [&](std::size_t block)
      {
        Work work(*this);
        const std::size_t first = block * cellsPerBlock;
        for (std::size_t i = first; i < std::min(cells_.size(), first + cellsPerBlock); ++i)
        {
          CellState state = this->load(i, work);
          isStraightened_[i] = work.shape.isStraightened;
          Eigen::Vector3d apex = work.cell.middle();
          if (isWithoutFraction(state))
          {
            apexes_[i].setConstant(std::numeric_limits<double>::quiet_NaN());
            states_[i] = state;
            continue;
          }
          if (state == CellState::clear && tree_ && tree_->reaches(this->reachOf(work.cell)))
          {
            state = rimTree_ && rimTree_->reaches(work.cell.box()) ? CellState::onRim
                                                                   : CellState::touched;
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
      const double level = isInside_.levelOf(winding + step);
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
    const CellState state = states_[cell];
    if (field_.info().jumpsOnly() || state == CellState::flat || isWithoutFraction(state))
    {
      return false;
    }
    return state == CellState::onRim || (state == CellState::touched && !surface_) ||
           this->isNearLimit(windings_[cell], state == CellState::touched);
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
        inside += ofCone * work.share.of(corners, work.moved, windings_[number], work.cell.cones());
      }
    }
    return shareOf(inside, volume);
  }

  /// Returns the share of a part that triangles meet, w at its apex being known. It is one of the
  /// parts of its cell that `division` divisions make.
  double shareOfPart(
    const CellPart& part, double winding, const LocalCell& cell, int division, Work& work) const
  {
    const std::size_t cones = (4 * cell.cones()) << (3 * division);
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
        inside += ofCone * work.share.of(corners, work.moved, winding, cones);
      }
    }
    return volume > 0 ? inside / volume : 0;
  }

  /// Divides cells where w changes off triangles, and adds up what is inside of their parts.
  void divide(const std::size_t* numbers, std::size_t count, float* fractions)
  {
    std::vector<LocalCell> locals(count);
    std::vector<CellPart> parts, next;
    Work work(*this);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->load(numbers[i], work);
      locals[i] = work.cell;
      addCones(work.cell, static_cast<std::uint32_t>(i), parts);
    }
    std::vector<double> inside(count, 0.0);
    for (int division = 0; !parts.empty(); ++division)
    {
      std::vector<double> shares(parts.size());
      this->findShares(locals, parts, division, shares);
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

  /// Sets the shares of parts, NaN for those to be divided further; the last division leaves none
  /// of these.
  void findShares(const std::vector<LocalCell>& locals, std::vector<CellPart>& parts, int division,
    std::vector<double>& shares)
  {
    forEachItem(
      parts.size(),
      [&](std::size_t i)
      {
        const Bounds box = boxOf(parts[i], locals[parts[i].cell]);
        parts[i].state = !surface_ || !tree_->reaches(box) ? CellState::clear
                         : rimTree_->reaches(box)          ? CellState::onRim
                                                           : CellState::touched;
      },
      executor_);
    std::vector<Eigen::Vector3d> samples;
    for (const CellPart& part : parts)
    {
      const LocalCell& cell = locals[part.cell];
      samples.push_back(cell.global(part.apex()));
      for (std::size_t i = 0; part.state == CellState::clear && i < 4; ++i)
      {
        samples.push_back(cell.global(part.corners[i]));
      }
    }
    std::vector<double> windings(samples.size());
    this->evaluate(samples, windings);
    std::vector<std::size_t> firsts;
    std::size_t first = 0;
    for (const CellPart& part : parts)
    {
      firsts.push_back(first);
      first += part.state == CellState::clear ? 5 : 1;
    }
    // Few parts may have many triangles each, and an interrupt is seen between blocks.
    const std::size_t partsPerBlock = std::clamp<std::size_t>(parts.size() / 256, 1, 512);
    runBlocks(
      parts.size(), partsPerBlock,
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        Work work(*this);
        for (std::size_t i = begin; i < end; ++i)
        {
          const double* const ofPart = windings.data() + firsts[i];
          const CellState state = parts[i].state;
          const bool isNear = state == CellState::onRim ||
                              (state == CellState::touched ? this->isNearLimit(ofPart[0], true)
                                                           : this->mayPass(ofPart));
          shares[i] = isNear && division < divisions ? std::numeric_limits<double>::quiet_NaN()
                      : state == CellState::clear    ? this->linearShare(ofPart)
                                                     : this->shareOfPart(parts[i], ofPart[0],
                                                         locals[parts[i].cell], division, work);
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
      const double level = isInside_.levelOf(windings[i]);
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
      levels[i] = isInside_.levelOf(windings[i + 1]);
    }
    return positivePart(levels);
  }

  const Field& field_;
  const CellShapes& cells_;
  const InsideTest isInside_;
  Executor& executor_;
  const Surface* const surface_;
  std::unique_ptr<const BoxTree> tree_, rimTree_;
  Surface rims_; ///< edges of the boundary
  std::vector<Eigen::Vector3d> apexes_;
  std::vector<CellState> states_;
  std::vector<char> isStraightened_; ///< by cell
  std::vector<double> windings_;
};

} // namespace

CellsWithoutFraction evaluateFractions(const Field& field, const CellShapes& cells,
  const InsideTest& isInside, float* fractions, Executor& executor)
{
  return Evaluation(field, cells, isInside, executor).run(fractions);
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
  add(counts.curved, "have curved faces", "fractions take them as straight between corners");
  add(counts.flat, "have no volume", "their fraction is 1 or 0, as their middle is inside or not");
  add(counts.open, "are not closed", "a face of each is missing or turned: they have no fraction");
  add(counts.nowhere, "are empty or not finite", "they have no fraction");
  return messages;
}

std::size_t bytesOfCellFractions(const Field& field, std::size_t cells)
{
  const std::size_t primitives = field.info().primitives;
  const bool isDivided = !field.info().jumpsOnly();
  // Cones, less than half of their eighths, and as many of theirs; each has five samples.
  constexpr std::size_t ofParts = cellsAtOnce * 200 * (sizeof(CellPart) + 5 * 32);
  constexpr std::size_t perCell = sizeof(Eigen::Vector3d) + sizeof(double) + sizeof(CellState) +
                                  sizeof(char) + sizeof(std::size_t);
  return BoxTree::bytesFor(primitives) +
         field.info().netBoundaryEdges * (sizeof(Triangle) + BoxTree::bytesFor(1)) +
         (isDivided ? primitives / 2 * sizeof(Eigen::Vector3d) : 0) + cells * perCell +
         (isDivided ? ofParts : 0);
}

} // namespace winding
