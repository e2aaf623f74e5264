// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/MeshSkin.h"

#include "mesh/CellTypes.h"
#include "source/PlaceHash.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace winding
{

namespace
{

using Ids = std::vector<std::int64_t>;

std::size_t placeOf(const IdsView& places, std::size_t number)
{
  return static_cast<std::size_t>(places[number]);
}

/// Sets `corners` to the corners of a polygon.
void setCorners(const SkinView& skin, std::size_t polygon, Ids& corners)
{
  corners.clear();
  for (std::size_t at = placeOf(skin.offsets, polygon); at < placeOf(skin.offsets, polygon + 1);
       ++at)
  {
    corners.push_back(skin.corners[at]);
  }
}

/// Returns twice the area of a polygon as a vector.
Eigen::Vector3d areaOf(const SkinView& skin, const Ids& corners)
{
  const auto at = [&](std::size_t i)
  {
    return skin.points[static_cast<std::size_t>(corners[i])];
  };
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    area += (at(i - 1) - at(0)).cross(at(i) - at(0));
  }
  return area;
}

/// Calls visit(edge, isForward) for each edge of a face, between two ids in their order.
template <class Visit> void forEachEdge(const Ids& face, const Visit& visit)
{
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    const std::int64_t from = face[i], to = face[(i + 1) % face.size()];
    visit(std::pair<std::int64_t, std::int64_t>(std::minmax(from, to)), from < to);
  }
}

/// Orients the faces of a polyhedron like the first one that they hang together with. Edges of more
/// than two faces say nothing.
void orientLikeEachOther(std::vector<Ids>& faces)
{
  struct Use
  {
    std::size_t face;
    bool isForward;
  };
  using Edge = std::pair<std::int64_t, std::int64_t>;
  std::map<Edge, std::vector<Use>> edges;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    forEachEdge(faces[face],
      [&](const Edge& edge, bool isForward) {
        edges[edge].push_back({face, isForward});
      });
  }
  std::vector<char> isReached(faces.size(), 0), isTurned(faces.size(), 0);
  std::vector<std::size_t> waiting;
  for (std::size_t first = 0; first < faces.size(); ++first)
  {
    if (!std::exchange(isReached[first], 1))
    {
      waiting.push_back(first);
    }
    while (!waiting.empty())
    {
      const std::size_t face = waiting.back();
      waiting.pop_back();
      forEachEdge(faces[face],
        [&](const Edge& edge, bool isForward)
        {
          const std::vector<Use>& uses = edges[edge];
          if (uses.size() != 2)
          {
            return;
          }
          const Use& other = uses[uses[0].face == face ? 1 : 0];
          if (!std::exchange(isReached[other.face], 1))
          {
            isTurned[other.face] = isTurned[face] != (other.isForward == isForward);
            waiting.push_back(other.face);
          }
        });
    }
  }
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    if (isTurned[face])
    {
      std::reverse(faces[face].begin(), faces[face].end());
    }
  }
}

/// The cells of a mesh, one after the other, as what the polygons of a skin look into or away from.
class Senses
{
public:
  Senses(const MeshView& mesh, const SkinView& skin)
    : mesh_(mesh)
    , skin_(skin)
  {
  }

  /// Returns whether a polygon looks into its own `cell`, which has a volume.
  bool isInward(std::size_t cell, const Ids& corners)
  {
    const int type = mesh_.types[cell];
    if (cell != cell_)
    {
      cell_ = cell;
      this->look(type);
    }
    if (isCurved(type))
    {
      // VTK divides the faces of other cells in the order of the straight ones.
      return straightTypeOf(type) == wedgeType ? this->looksAtMiddle(corners) : isInward_;
    }
    const Sense sense = skin_.origins.empty() ? Sense::unknown : this->senseOf(corners);
    return sense == Sense::unknown ? this->looksAtMiddle(corners)
                                   : isInward_ != (sense == Sense::reversed);
  }

private:
  static constexpr int wedgeType = 13;

  enum class Sense
  {
    forward,
    reversed,
    unknown
  };

  Eigen::Vector3d pointOf(std::int64_t id) const
  {
    return mesh_.points[static_cast<std::size_t>(id)];
  }

  /// Finds the faces of the cell, and whether they look inward.
  void look(int type)
  {
    const std::size_t first = placeOf(mesh_.offsets, cell_),
                      last = placeOf(mesh_.offsets, cell_ + 1);
    std::size_t count = 0;
    const auto addFace = [&]() -> Ids&
    {
      faces_.resize(std::max(faces_.size(), ++count)); // memory is kept from cell to cell
      faces_[count - 1].clear();
      return faces_[count - 1];
    };
    if (type == polyhedronType)
    {
      for (std::size_t at = first + 1; at < last;)
      {
        const std::size_t end = at + 1 + placeOf(mesh_.corners, at);
        Ids& face = addFace();
        for (++at; at < end; ++at)
        {
          face.push_back(mesh_.corners[at]);
        }
        count -= face.size() > 2 ? 0 : 1;
      }
      faces_.resize(count);
      orientLikeEachOther(faces_);
    }
    else
    {
      bool isOpen = false;
      for (const int corner : facesOf(straightTypeOf(type)))
      {
        if (corner >= 0)
        {
          Ids& face = isOpen ? faces_[count - 1] : addFace();
          face.push_back(mesh_.corners[first + static_cast<std::size_t>(corner)]);
        }
        isOpen = corner >= 0;
      }
      faces_.resize(count);
    }
    isInward_ = this->volume() < 0;
    rows_.clear();
    for (const Ids& face : faces_)
    {
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        rows_.push_back({face[i], face[(i + 1) % face.size()], face[(i + 2) % face.size()]});
      }
    }
    std::sort(rows_.begin(), rows_.end());
  }

  /// Returns six times the volume within the faces, which is negative where they look inward.
  double volume() const
  {
    double volume = 0;
    for (const Ids& face : faces_)
    {
      const Eigen::Vector3d origin = this->pointOf(faces_.front().front());
      const Eigen::Vector3d first = this->pointOf(face[0]) - origin;
      for (std::size_t i = 2; i < face.size(); ++i)
      {
        volume +=
          first.dot((this->pointOf(face[i - 1]) - origin).cross(this->pointOf(face[i]) - origin));
      }
    }
    return volume;
  }

  /// Returns whether a polygon goes round as the face of the cell that it is.
  Sense senseOf(const Ids& corners) const
  {
    std::array<std::int64_t, 3> ids;
    for (std::size_t i = 0; i < 3; ++i)
    {
      ids[i] = skin_.origins[static_cast<std::size_t>(corners[i])];
    }
    if (std::binary_search(rows_.begin(), rows_.end(), ids))
    {
      return Sense::forward;
    }
    std::reverse(ids.begin(), ids.end());
    return std::binary_search(rows_.begin(), rows_.end(), ids) ? Sense::reversed : Sense::unknown;
  }

  /// Returns whether a polygon looks to the side where the middle of the cell's points is.
  bool looksAtMiddle(const Ids& corners) const
  {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), centre = middle;
    for (const std::int64_t corner : corners)
    {
      middle +=
        skin_.points[static_cast<std::size_t>(corner)] / static_cast<double>(corners.size());
    }
    std::size_t count = 0;
    const auto add = [&](std::int64_t id)
    {
      centre += this->pointOf(id);
      ++count;
    };
    if (mesh_.types[cell_] == polyhedronType)
    {
      for (const Ids& face : faces_)
      {
        std::for_each(face.begin(), face.end(), add);
      }
    }
    else
    {
      for (std::size_t at = placeOf(mesh_.offsets, cell_); at < placeOf(mesh_.offsets, cell_ + 1);
           ++at)
      {
        add(mesh_.corners[at]);
      }
    }
    return count > 0 &&
           (middle - centre / static_cast<double>(count)).dot(areaOf(skin_, corners)) < 0;
  }

  const MeshView& mesh_;
  const SkinView& skin_;
  std::size_t cell_ = static_cast<std::size_t>(-1); ///< the last one
  std::vector<Ids> faces_;                          ///< of that cell, agreeing with each other
  std::vector<std::array<std::int64_t, 3>> rows_;   ///< corners in a row of these, sorted
  bool isInward_ = false;                           ///< whether these look inward
};

/// Finds seams: by polygon, whether it is there in the other sense, too.
class Seams
{
public:
  explicit Seams(const SkinView& skin)
    : firsts_(skin.points.size())
    , isShared_(skin.points.size(), 0)
    , isSeam_(skin.polygons(), 0)
  {
    std::unordered_map<std::array<double, 3>, std::int64_t, PlaceHash> places;
    places.reserve(skin.points.size());
    for (std::size_t point = 0; point < skin.points.size(); ++point)
    {
      firsts_[point] = static_cast<std::int64_t>(point);
      const Eigen::Vector3d at = skin.points[point];
      if (!at.allFinite())
      {
        continue; // NaN is at no place
      }
      const auto [first, isNew] = places.emplace(
        std::array{at.x() + 0.0, at.y() + 0.0, at.z() + 0.0}, static_cast<std::int64_t>(point));
      firsts_[point] = first->second;
      areAny_ = areAny_ || !isNew;
      isShared_[static_cast<std::size_t>(first->second)] |= !isNew;
    }
  }

  /// Adds a polygon that looks outward.
  void add(std::size_t polygon, const Ids& ids)
  {
    if (!areAny_)
    {
      return;
    }
    Ids corners = ids;
    for (std::int64_t& corner : corners)
    {
      corner = firsts_[static_cast<std::size_t>(corner)];
      if (!isShared_[static_cast<std::size_t>(corner)])
      {
        return;
      }
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const bool ascends = corners[1] < corners.back();
    if (!ascends)
    {
      std::reverse(corners.begin() + 1, corners.end());
    }
    auto& [down, up] = open_[corners];
    std::vector<std::size_t>& others = ascends ? down : up;
    if (others.empty())
    {
      (ascends ? up : down).push_back(polygon);
      return;
    }
    isSeam_[polygon] = isSeam_[others.back()] = 1;
    others.pop_back();
  }

  bool isSeam(std::size_t polygon) const { return isSeam_[polygon] != 0; }

private:
  Ids firsts_;                 ///< by point, the first one at its place
  std::vector<char> isShared_; ///< by first point, whether there are others
  bool areAny_ = false;
  std::vector<char> isSeam_;
  /// By corners from the lowest on, polygons whose opposite has not come yet, by their sense.
  std::map<Ids, std::array<std::vector<std::size_t>, 2>> open_;
};

/// Returns the areas of the polygons of each cell, added up.
std::vector<double> areasByCell(const SkinView& skin, std::size_t cells)
{
  std::vector<double> areas(cells, 0);
  Ids corners;
  for (std::size_t polygon = 0; polygon < skin.polygons(); ++polygon)
  {
    setCorners(skin, polygon, corners);
    areas[placeOf(skin.owners, polygon)] += areaOf(skin, corners).norm() / 2;
  }
  return areas;
}

} // namespace

OutwardPolygons outwardPolygons(const MeshView& mesh, const SkinView& skin, CellCounts& counts)
{
  OutwardPolygons outward;
  Ids& ids = outward.corners;
  outward.offsets.push_back(0);
  Senses senses(mesh, skin);
  Seams seams(skin);
  std::vector<char> isTurned(mesh.cells(), 0);
  Ids corners;
  for (std::size_t polygon = 0; polygon < skin.polygons(); ++polygon)
  {
    setCorners(skin, polygon, corners);
    const std::size_t owner = placeOf(skin.owners, polygon);
    if (corners.size() > 2 && dimensionOf(mesh.types[owner]) == 3)
    {
      if (senses.isInward(owner, corners))
      {
        std::reverse(corners.begin() + 1, corners.end());
        counts.turned += !std::exchange(isTurned[owner], 1);
      }
      seams.add(polygon, corners);
    }
    ids.insert(ids.end(), corners.begin(), corners.end());
    outward.offsets.push_back(static_cast<std::int64_t>(ids.size()));
  }
  std::size_t kept = 0;
  auto end = ids.begin();
  for (std::size_t polygon = 0; polygon < skin.polygons(); ++polygon)
  {
    const auto first = ids.begin() + outward.offsets[polygon];
    const auto last = ids.begin() + outward.offsets[polygon + 1];
    if (!seams.isSeam(polygon))
    {
      outward.offsets[kept++] = end - ids.begin();
      end = std::copy(first, last, end);
      outward.polygons.push_back(static_cast<std::int64_t>(polygon));
    }
  }
  outward.offsets[kept] = end - ids.begin();
  outward.offsets.resize(kept + 1);
  ids.erase(end, ids.end());
  return outward;
}

int halvingsOf(const SkinView& once, const SkinView& twice, std::size_t cells, double diagonal,
  CellCounts& counts)
{
  constexpr int most = 5;
  const double wanted = 1e-3 * std::max(diagonal, 0.0);
  const std::vector<double> coarse = areasByCell(once, cells), fine = areasByCell(twice, cells);
  int halvings = 1;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    // A face of area A has sides of about √A, and two chords a side after one halving.
    const double rise = std::sqrt(std::abs(fine[cell] - coarse[cell]) * 3 / 8) / 2;
    const double needed = rise > wanted ? 1 + std::ceil(std::log(rise / wanted) / std::log(4)) : 1;
    halvings = std::max(halvings, static_cast<int>(std::min<double>(most, needed)));
    counts.flat += needed > most ? 1 : 0;
  }
  return halvings;
}

} // namespace winding
