#include "GridContour.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMarchingCubesTriangleCases.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace winding
{

namespace
{

constexpr std::size_t verticesPerBlock = 8192;

/// How close vertices may come to the ends of their edges. Far less than what is seen, but more than
/// what single precision rounds.
constexpr double margin = 1.0 / (1 << 12);

/// The same in the middle of a grid that has one more sample on each side.
vtkSmartPointer<vtkUnsignedCharArray> withBorderOf(
  vtkUnsignedCharArray* inside, const Eigen::Vector3i& dimensions)
{
  const Eigen::Vector3i padded = dimensions + Eigen::Vector3i::Constant(2);
  auto result = vtkSmartPointer<vtkUnsignedCharArray>::New();
  result->SetNumberOfTuples(padded.cast<vtkIdType>().prod());
  unsigned char* to = result->GetPointer(0);
  std::fill_n(to, result->GetNumberOfTuples(), static_cast<unsigned char>(0));
  const unsigned char* from = inside->GetPointer(0);
  for (int k = 1; k <= dimensions[2]; ++k)
  {
    for (int j = 1; j <= dimensions[1]; ++j)
    {
      const vtkIdType row = static_cast<vtkIdType>(k) * padded[1] + j;
      std::copy_n(from, dimensions[0], to + row * padded[0] + 1);
      from += dimensions[0];
    }
  }
  return result;
}

/// Calls visit(i) for every i below count at which two rows of 0 and 1 differ, ascending.
template <class Visit>
void forEachDifference(
  const unsigned char* one, const unsigned char* other, int count, const Visit& visit)
{
  // Most do not, and so many are compared at once, in a way that compilers turn into vectors.
  constexpr int atOnce = 16;
  for (int first = 0; first < count; first += atOnce)
  {
    const int last = std::min(count, first + atOnce);
    unsigned char differs = 0;
    if (last - first == atOnce)
    {
      for (int i = 0; i < atOnce; ++i)
      {
        differs |= one[first + i] ^ other[first + i];
      }
      if (differs == 0)
      {
        continue;
      }
    }
    for (int i = first; i < last; ++i)
    {
      if (one[i] != other[i])
      {
        visit(i);
      }
    }
  }
}

/// The samples of an image of 0 and 1, and the vertices between them, by the rows that they begin in.
class RowsOfVertices
{
public:
  RowsOfVertices(
    const unsigned char* samples, const Eigen::Vector3i& dimensions, Executor& executor)
    : samples_(samples)
    , n_(dimensions)
    , starts_(this->lineOf(0, 0, n_[2]) + 1, 0)
  {
    std::vector<std::vector<GridEdge>> layers(static_cast<std::size_t>(n_[2]));
    runBlocks(
      layers.size(), 1,
      [&](std::size_t k, std::size_t, std::size_t)
      { this->findVertices(static_cast<int>(k), layers[k]); },
      executor);
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    vertices_.resize(starts_.back());
    runBlocks(
      layers.size(), 1,
      [&](std::size_t k, std::size_t, std::size_t)
      {
        std::copy(layers[k].begin(), layers[k].end(),
          vertices_.begin() + starts_[this->lineOf(0, 0, static_cast<int>(k))]);
      },
      executor);
  }

  const unsigned char* row(int j, int k) const
  {
    return samples_ + (static_cast<std::size_t>(k) * n_[1] + j) * n_[0];
  }

  /// The vertices on the edges along an axis that begin in a row.
  class Line
  {
  public:
    Line(const RowsOfVertices& rows, int axis, int j, int k)
      : reach_(axis == 0 ? 0 : 1)
      , next_(rows.starts_[rows.lineOf(axis, j, k)])
      , vertex_(rows.vertices_.data() + next_)
      , end_(rows.vertices_.data() + rows.starts_[rows.lineOf(axis, j, k) + 1])
    {
    }

    /// First cell from `cell` on that has a vertex of the line; `none` if there is none.
    int firstCell(int cell, int none) const
    {
      return vertex_ == end_ ? none : std::max(cell, vertex_->sample[0] - reach_);
    }

    /// Numbers of the vertices at i and at i + 1, where there are these.
    std::pair<std::size_t, std::size_t> at(int i) const
    {
      return {next_, next_ + (vertex_ != end_ && vertex_->sample[0] == i)};
    }

    /// Leaves those at i and before behind.
    void pass(int i)
    {
      const bool isThere = vertex_ != end_ && vertex_->sample[0] == i;
      vertex_ += isThere;
      next_ += isThere;
    }

  private:
    int reach_; ///< a vertex belongs to so many more cells before its own
    std::size_t next_;
    const GridEdge *vertex_, *end_;
  };

  std::vector<GridEdge>& vertices() { return vertices_; }

private:
  std::size_t lineOf(int axis, int j, int k) const
  {
    return 3 * (static_cast<std::size_t>(k) * n_[1] + j) + axis;
  }

  /// Those of a layer, and how many each of its lines has.
  void findVertices(int k, std::vector<GridEdge>& vertices)
  {
    for (int j = 0; j < n_[1]; ++j)
    {
      const unsigned char* here = this->row(j, k);
      const auto findAlong = [&](int axis, const unsigned char* there, int count)
      {
        const std::size_t before = vertices.size();
        forEachDifference(here, there, count,
          [&](int i) {
            vertices.push_back(GridEdge{{i, j, k}, axis});
          });
        starts_[this->lineOf(axis, j, k) + 1] = vertices.size() - before;
      };
      findAlong(0, here + 1, n_[0] - 1);
      if (j + 1 < n_[1])
      {
        findAlong(1, this->row(j + 1, k), n_[0]);
      }
      if (k + 1 < n_[2])
      {
        findAlong(2, this->row(j, k + 1), n_[0]);
      }
    }
  }

  const unsigned char* samples_;
  Eigen::Vector3i n_;
  std::vector<std::size_t> starts_; ///< of the vertices of each line
  std::vector<GridEdge> vertices_;
};

/// Adds the corners of the triangles in the cells between four rows: those that have a vertex.
void addTriangles(
  const RowsOfVertices& rows, int width, int j, int k, std::vector<vtkIdType>& corners)
{
  const unsigned char* row[4] = {
    rows.row(j, k), rows.row(j + 1, k), rows.row(j, k + 1), rows.row(j + 1, k + 1)};
  // Four along x, then two along y and two along z.
  RowsOfVertices::Line lines[8] = {{rows, 0, j, k}, {rows, 0, j + 1, k}, {rows, 0, j, k + 1},
    {rows, 0, j + 1, k + 1}, {rows, 1, j, k}, {rows, 1, j, k + 1}, {rows, 2, j, k},
    {rows, 2, j + 1, k}};
  const vtkMarchingCubesTriangleCases* cases = vtkMarchingCubesTriangleCases::GetCases();
  const int cells = width - 1;
  for (int i = 0; i < cells; ++i)
  {
    int next = cells;
    for (const RowsOfVertices::Line& line : lines)
    {
      next = std::min(next, line.firstCell(i, cells));
    }
    i = next;
    if (i == cells)
    {
      break;
    }
    // Corners and edges in the order of VTK's table.
    const int index = row[0][i] | row[0][i + 1] << 1 | row[1][i + 1] << 2 | row[1][i] << 3 |
                      row[2][i] << 4 | row[2][i + 1] << 5 | row[3][i + 1] << 6 | row[3][i] << 7;
    const auto y0 = lines[4].at(i), y1 = lines[5].at(i);
    const auto z0 = lines[6].at(i), z1 = lines[7].at(i);
    const std::size_t vertices[12] = {lines[0].at(i).first, y0.second, lines[1].at(i).first,
      y0.first, lines[2].at(i).first, y1.second, lines[3].at(i).first, y1.first, z0.first,
      z0.second, z1.first, z1.second};
    for (const int* edge = cases[index].edges; *edge >= 0; ++edge)
    {
      corners.push_back(static_cast<vtkIdType>(vertices[*edge]));
    }
    for (RowsOfVertices::Line& line : lines)
    {
      line.pass(i);
    }
  }
}

vtkSmartPointer<vtkCellArray> trianglesOf(const std::vector<std::vector<vtkIdType>>& corners)
{
  std::size_t count = 0;
  for (const std::vector<vtkIdType>& some : corners)
  {
    count += some.size();
  }
  vtkNew<vtkIdTypeArray> connectivity, offsets;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(count));
  vtkIdType* next = connectivity->GetPointer(0);
  for (const std::vector<vtkIdType>& some : corners)
  {
    next = std::copy(some.begin(), some.end(), next);
  }
  offsets->SetNumberOfValues(static_cast<vtkIdType>(count / 3 + 1));
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->SetData(offsets, connectivity);
  return triangles;
}

/// Adds twice the vector area of every triangle to its corners. unit: about the size of a triangle, so
/// that no unit of length leaves the range of numbers.
template <class Real>
void addAreas(
  vtkCellArray* triangles, const Real* coordinates, double unit, std::vector<Eigen::Vector3d>& sums)
{
  using Point = Eigen::Map<const Eigen::Matrix<Real, 3, 1>>;
  const auto scaled = [unit](const auto& vector) -> Eigen::Vector3d
  {
    return vector.template cast<double>() / unit;
  };
  vtkIdType corners = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    triangles->GetCellAtId(cell, corners, ids);
    const Point a(coordinates + 3 * ids[0]), b(coordinates + 3 * ids[1]);
    const Point c(coordinates + 3 * ids[2]);
    const Eigen::Vector3d area = scaled(b - a).cross(scaled(c - a));
    for (vtkIdType corner = 0; corner < 3; ++corner)
    {
      sums[static_cast<std::size_t>(ids[corner])] += area;
    }
  }
}

} // namespace

GridContour::GridContour(
  const Grid& grid, vtkUnsignedCharArray* inside, bool withBorder, Executor& executor)
  : grid_(grid)
{
  const int border = withBorder ? 1 : 0;
  const Eigen::Vector3i dimensions = grid.dimensions + Eigen::Vector3i::Constant(2 * border);
  vtkSmartPointer<vtkUnsignedCharArray> samples = inside;
  if (withBorder)
  {
    samples = withBorderOf(inside, grid.dimensions);
  }
  RowsOfVertices rows(samples->GetPointer(0), dimensions, executor);
  std::vector<std::vector<vtkIdType>> corners(static_cast<std::size_t>(dimensions[2] - 1));
  runBlocks(
    corners.size(), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    {
      for (int j = 0; j + 1 < dimensions[1]; ++j)
      {
        addTriangles(rows, dimensions[0], j, static_cast<int>(layer), corners[layer]);
      }
    },
    executor);
  triangles_ = trianglesOf(corners);
  vertices_ = std::move(rows.vertices());
  for (GridEdge& vertex : vertices_)
  {
    for (int& index : vertex.sample)
    {
      index -= border;
    }
  }
}

bool GridContour::isAtBorder(const GridEdge& vertex) const
{
  const int sample = vertex.sample[vertex.axis];
  return sample < 0 || sample == grid_.dimensions[vertex.axis] - 1;
}

std::vector<GridEdge> GridContour::edges() const
{
  std::vector<GridEdge> edges;
  edges.reserve(vertices_.size());
  std::copy_if(vertices_.begin(), vertices_.end(), std::back_inserter(edges),
    [this](const GridEdge& vertex) { return !this->isAtBorder(vertex); });
  return edges;
}

vtkSmartPointer<vtkPoints> GridContour::place(
  const std::vector<double>& fractions, int type, Executor& executor) const
{
  std::vector<double> ofVertices(vertices_.size());
  auto fraction = fractions.begin();
  for (std::size_t i = 0; i < vertices_.size(); ++i)
  {
    ofVertices[i] =
      this->isAtBorder(vertices_[i]) ? 0.5 : std::clamp(*fraction++, margin, 1 - margin);
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(vertices_.size()));
  runBlocks(
    vertices_.size(), verticesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const GridEdge& vertex = vertices_[i];
        Eigen::Vector3d steps(vertex.sample[0], vertex.sample[1], vertex.sample[2]);
        steps[vertex.axis] += ofVertices[i];
        const Eigen::Vector3d position = grid_.firstSample + steps.cwiseProduct(grid_.spacing);
        points->SetPoint(static_cast<vtkIdType>(i), position.data());
      }
    },
    executor);
  return points;
}

vtkSmartPointer<vtkFloatArray> GridContour::normalsOf(vtkPoints* points, Executor& executor) const
{
  const double unit = grid_.spacing.maxCoeff();
  std::vector<Eigen::Vector3d> sums(vertices_.size(), Eigen::Vector3d::Zero());
  if (points->GetDataType() == VTK_DOUBLE)
  {
    addAreas(triangles_, static_cast<const double*>(points->GetVoidPointer(0)), unit, sums);
  }
  else
  {
    addAreas(triangles_, static_cast<const float*>(points->GetVoidPointer(0)), unit, sums);
  }
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(points->GetNumberOfPoints());
  runBlocks(
    sums.size(), verticesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::Vector3d normal = sums[i].stableNormalized();
        for (int axis = 0; axis < 3; ++axis)
        {
          normals->SetTypedComponent(
            static_cast<vtkIdType>(i), axis, static_cast<float>(normal[axis]));
        }
      }
    },
    executor);
  return normals;
}

} // namespace winding
