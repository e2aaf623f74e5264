#include "private/output/SharpContour.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>

namespace winding
{

namespace
{

constexpr std::size_t edgesPerBlock = 4096;

} // namespace

SharpContour::SharpContour(const Field& field, const Grid& grid, const LevelEdges& edges,
  const LevelRoots& roots, bool areTriangles, Executor& executor)
  : grid_(grid)
  , edges_(edges)
  , areTriangles_(areTriangles)
  , mesh_(grid, edges, executor)
  , vertices_(field, grid, edges, roots, mesh_, executor)
  , splits_(edges.size(), QuadSplit::first)
  , starts_((edges.size() + edgesPerBlock - 1) / edgesPerBlock + 1)
{
  runBlocks(
    edges.size(), edgesPerBlock,
    [this](std::size_t block, std::size_t first, std::size_t last)
    {
      Start& counts = starts_[block + 1];
      for (std::size_t edge = first; edge < last; ++edge)
      {
        if (!mesh_.isComplete(edge))
        {
          continue;
        }
        splits_[edge] = vertices_.splitOf(edge);
        const bool isFan = splits_[edge] == QuadSplit::fan;
        counts.fan += isFan;
        counts.polygon += isFan ? 4 : areTriangles_ ? 2 : 1;
        counts.corner += isFan ? 12 : areTriangles_ ? 6 : 4;
      }
    },
    executor);
  for (std::size_t block = 0; block < this->blocks(); ++block)
  {
    starts_[block + 1].polygon += starts_[block].polygon;
    starts_[block + 1].corner += starts_[block].corner;
    starts_[block + 1].fan += starts_[block].fan;
  }
  fans_.reserve(starts_.back().fan);
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    if (splits_[edge] == QuadSplit::fan)
    {
      fans_.push_back(static_cast<std::uint32_t>(edge));
    }
  }
}

/// Calls visit(vertices, count) for each polygon of a block of edges.
template <class Visit> void SharpContour::forPolygons(std::size_t block, const Visit& visit) const
{
  std::size_t fan = mesh_.size() + starts_[block].fan;
  const std::size_t end = std::min(edges_.size(), (block + 1) * edgesPerBlock);
  for (std::size_t edge = block * edgesPerBlock; edge < end; ++edge)
  {
    if (!mesh_.isComplete(edge))
    {
      continue;
    }
    // Corners go around the edge as seen from its end, and around what leaves the inside there.
    const DualMesh::Quad& quad = mesh_.quad(edge);
    const std::size_t from = splits_[edge] == QuadSplit::second ? 1 : 0;
    const std::size_t step = edges_[edge].firstIsInside ? 1 : 3;
    std::size_t corners[4];
    for (std::size_t n = 0; n < 4; ++n)
    {
      corners[n] = quad[(from + n * step) % 4];
    }
    if (splits_[edge] == QuadSplit::fan)
    {
      for (std::size_t n = 0; n < 4; ++n)
      {
        const std::size_t triangle[3] = {fan, corners[n], corners[(n + 1) % 4]};
        visit(triangle, 3);
      }
      ++fan;
    }
    else if (areTriangles_)
    {
      const std::size_t second[3] = {corners[0], corners[2], corners[3]};
      visit(corners, 3);
      visit(second, 3);
    }
    else
    {
      visit(corners, 4);
    }
  }
}

/// The place of a vertex in units of the grid.
Eigen::Vector3d SharpContour::placeOf(std::size_t vertex) const
{
  return vertex < mesh_.size() ? vertices_.places()[vertex]
                               : vertices_.crossing(fans_[vertex - mesh_.size()]);
}

vtkSmartPointer<vtkPoints> SharpContour::points(int type, Executor& executor) const
{
  const std::size_t count = mesh_.size() + fans_.size();
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  runBlocks(
    count, edgesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t vertex = first; vertex < last; ++vertex)
      {
        const Eigen::Vector3d position =
          grid_.firstSample + this->placeOf(vertex).cwiseProduct(grid_.spacing);
        points->SetPoint(static_cast<vtkIdType>(vertex), position.data());
      }
    },
    executor);
  return points;
}

vtkSmartPointer<vtkCellArray> SharpContour::polygons(Executor& executor) const
{
  vtkNew<vtkTypeInt64Array> connectivity, offsets;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(starts_.back().corner));
  offsets->SetNumberOfValues(static_cast<vtkIdType>(starts_.back().polygon + 1));
  runBlocks(
    this->blocks(), 1,
    [&](std::size_t block, std::size_t, std::size_t)
    {
      auto polygon = static_cast<vtkIdType>(starts_[block].polygon);
      auto corner = static_cast<vtkIdType>(starts_[block].corner);
      this->forPolygons(block,
        [&](const std::size_t* vertices, int count)
        {
          offsets->SetValue(polygon++, corner);
          for (int n = 0; n < count; ++n)
          {
            connectivity->SetValue(corner++, static_cast<vtkTypeInt64>(vertices[n]));
          }
        });
    },
    executor);
  offsets->SetValue(static_cast<vtkIdType>(starts_.back().polygon),
    static_cast<vtkTypeInt64>(starts_.back().corner));
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  polygons->SetData(offsets, connectivity);
  return polygons;
}

vtkSmartPointer<vtkFloatArray> SharpContour::normals(Executor& executor) const
{
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(starts_.back().polygon));
  const Eigen::Vector3d units = grid_.spacing / grid_.spacing.maxCoeff();
  runBlocks(
    this->blocks(), 1,
    [&](std::size_t block, std::size_t, std::size_t)
    {
      auto polygon = static_cast<vtkIdType>(starts_[block].polygon);
      this->forPolygons(block,
        [&](const std::size_t* vertices, int count)
        {
          const auto place = [&](int n) -> Eigen::Vector3d
          {
            return this->placeOf(vertices[n]).cwiseProduct(units);
          };
          // A triangle is a quad that ends where it begins.
          const Eigen::Vector3d first = place(0);
          const Eigen::Vector3d last = count == 3 ? first : place(3);
          const Eigen::Vector3d area = (place(2) - first).cross(last - place(1));
          const Eigen::Vector3f normal = area.stableNormalized().cast<float>();
          std::copy_n(normal.data(), 3, normals->GetPointer(3 * polygon++));
        });
    },
    executor);
  return normals;
}

} // namespace winding
