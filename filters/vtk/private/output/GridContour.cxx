#include "private/output/GridContour.h"

#include "level/CrossedCells.h"
#include "private/pipeline/VtkVersions.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cstdint>

namespace winding
{

namespace
{

constexpr std::size_t verticesPerBlock = 8192;

/// Vertices stay so far away from the ends of their edges: far less than anybody sees, but more
/// than what single precision rounds.
constexpr double margin = 1.0 / (1 << 12);

/// Adds the corners of the triangles in the cells between four rows.
void addTriangles(const LevelEdges& edges, int j, int k, int firstCell, int endOfCells,
  std::vector<std::uint32_t>& corners)
{
  const MarchingCubesTable table;
  forCrossedCells(edges, j, k, firstCell, endOfCells,
    [&](int, int inside, const CellEdges& vertices)
    {
      for (const int* edge = table[inside]; *edge >= 0; ++edge)
      {
        corners.push_back(static_cast<std::uint32_t>(vertices[static_cast<std::size_t>(*edge)]));
      }
    });
}

/// Triangles of these corners, and where those of each list begin.
vtkSmartPointer<vtkCellArray> trianglesOf(const std::vector<std::vector<std::uint32_t>>& corners,
  std::vector<vtkIdType>& starts, Executor& executor)
{
  starts.assign(1, 0);
  for (const std::vector<std::uint32_t>& some : corners)
  {
    starts.push_back(starts.back() + static_cast<vtkIdType>(some.size() / 3));
  }
  vtkNew<vtkTypeInt64Array> connectivity, offsets;
  connectivity->SetNumberOfValues(3 * starts.back());
  offsets->SetNumberOfValues(starts.back() + 1);
  runBlocks(
    corners.size(), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    {
      std::copy(
        corners[layer].begin(), corners[layer].end(), connectivity->GetPointer(3 * starts[layer]));
      for (vtkIdType triangle = starts[layer]; triangle < starts[layer + 1]; ++triangle)
      {
        offsets->SetValue(triangle, 3 * triangle);
      }
    },
    executor);
  offsets->SetValue(starts.back(), 3 * starts.back());
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->SetData(offsets, connectivity);
  return triangles;
}

} // namespace

GridContour::GridContour(const Grid& grid, const LevelEdges& edges, Executor& executor)
  : grid_(grid)
  , edges_(edges)
{
  const int first = -edges.border();
  const Eigen::Vector3i end = grid.dimensions - Eigen::Vector3i::Constant(1 + first);
  std::vector<std::vector<std::uint32_t>> corners(static_cast<std::size_t>(end[2] - first));
  runBlocks(
    corners.size(), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    {
      const int k = first + static_cast<int>(layer);
      // Closed surfaces have about twice as many triangles as vertices.
      const std::size_t vertices =
        edges.inRow(0, first, k + 1).first - edges.inRow(0, first, k).first;
      corners[layer].reserve(6 * vertices + vertices / 2);
      for (int j = first; j < end[1]; ++j)
      {
        addTriangles(edges, j, k, first, end[0], corners[layer]);
      }
    },
    executor);
  triangles_ = trianglesOf(corners, layerStarts_, executor);
}

vtkSmartPointer<vtkPoints> GridContour::place(
  const std::vector<double>& fractions, int type, Executor& executor) const
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(edges_.size()));
  runBlocks(
    edges_.size(), verticesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const GridEdge& edge = edges_[i];
        Eigen::Vector3d steps(edge.sample[0], edge.sample[1], edge.sample[2]);
        steps[edge.axis] += std::clamp(fractions[i], margin, 1 - margin);
        const Eigen::Vector3d position = grid_.firstSample + steps.cwiseProduct(grid_.spacing);
        points->SetPoint(static_cast<vtkIdType>(i), position.data());
      }
    },
    executor);
  return points;
}

/// Adds twice the vector area of every triangle to its corners, in units of a voxel, so that no
/// unit of length leaves the range of numbers.
template <class Real>
void GridContour::addAreas(
  const Real* coordinates, std::vector<Eigen::Vector3d>& sums, Executor& executor) const
{
  using Point = Eigen::Map<const Eigen::Matrix<Real, 3, 1>>;
  const double unit = grid_.spacing.maxCoeff();
  const auto scaled = [unit](const auto& vector) -> Eigen::Vector3d
  {
    return vector.template cast<double>() / unit;
  };
  const auto* ids =
    static_cast<const vtkTypeInt64*>(triangles_->GetConnectivityArray()->GetVoidPointer(0));
  const std::size_t layers = layerStarts_.size() - 1;
  // The triangles of a layer share vertices with those of the next one, but with no others.
  for (std::size_t parity = 0; parity < 2; ++parity)
  {
    runBlocks((layers + 1 - parity) / 2, 1,
      [&](std::size_t n, std::size_t, std::size_t)
      {
        const std::size_t layer = 2 * n + parity;
        for (vtkIdType triangle = layerStarts_[layer]; triangle < layerStarts_[layer + 1];
             ++triangle)
        {
          const vtkTypeInt64* corner = ids + 3 * triangle;
          const Point a(coordinates + 3 * corner[0]), b(coordinates + 3 * corner[1]);
          const Point c(coordinates + 3 * corner[2]);
          const Eigen::Vector3d area = scaled(b - a).cross(scaled(c - a));
          for (int i = 0; i < 3; ++i)
          {
            sums[static_cast<std::size_t>(corner[i])] += area;
          }
        }
      },
      executor);
  }
}

/// For every vertex, the sum of its triangles' vector areas.
std::vector<Eigen::Vector3d> GridContour::areasAround(vtkPoints* points, Executor& executor) const
{
  std::vector<Eigen::Vector3d> sums(edges_.size(), Eigen::Vector3d::Zero());
  if (points->GetDataType() == VTK_DOUBLE)
  {
    this->addAreas(
      static_cast<const double*>(points->GetData()->GetVoidPointer(0)), sums, executor);
  }
  else
  {
    this->addAreas(static_cast<const float*>(points->GetData()->GetVoidPointer(0)), sums, executor);
  }
  return sums;
}

vtkSmartPointer<vtkFloatArray> GridContour::normalsOf(
  vtkPoints* points, const std::vector<Eigen::Vector3f>& known, Executor& executor) const
{
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(points->GetNumberOfPoints());
  const auto set = [&normals](std::size_t vertex, const Eigen::Vector3f& normal)
  {
    std::copy_n(normal.data(), 3, normals->GetPointer(3 * static_cast<vtkIdType>(vertex)));
  };
  std::vector<std::vector<std::size_t>> left(
    (edges_.size() + verticesPerBlock - 1) / verticesPerBlock);
  runBlocks(
    edges_.size(), verticesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const GridEdge& edge = edges_[i];
        const float along = known[i][edge.axis];
        if (along != 0)
        {
          // The surface is left along its edge, from the sample inside to that outside.
          const float sense = (along > 0) == edge.firstIsInside ? 1.0f : -1.0f;
          set(i, sense * known[i]);
        }
        else
        {
          left[block].push_back(i);
        }
      }
    },
    executor);
  if (std::any_of(left.begin(), left.end(), [](const auto& some) { return !some.empty(); }))
  {
    const std::vector<Eigen::Vector3d> areas = this->areasAround(points, executor);
    runBlocks(
      left.size(), 1,
      [&](std::size_t block, std::size_t, std::size_t)
      {
        for (const std::size_t i : left[block])
        {
          set(i, areas[i].stableNormalized().cast<float>());
        }
      },
      executor);
  }
  return normals;
}

} // namespace winding
