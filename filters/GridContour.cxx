#include "GridContour.h"

#include "SmpExecutor.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

/// Where the contour of 0 and 1 at 0.5 has its vertices: in the middle of an edge.
GridEdge edgeAround(const float* middle)
{
  GridEdge edge = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    const float low = std::floor(middle[axis]);
    edge.sample[axis] = static_cast<int>(low);
    edge.axis = low < middle[axis] ? axis : edge.axis;
  }
  return edge;
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
  const Grid& grid, vtkUnsignedCharArray* inside, bool withBorder, SmpExecutor& executor)
  : grid_(grid)
{
  const int border = withBorder ? 1 : 0;
  const Eigen::Vector3i dimensions = grid.dimensions + Eigen::Vector3i::Constant(2 * border);
  vtkNew<vtkImageData> image;
  image->SetDimensions(dimensions.data());
  image->SetOrigin(-border, -border, -border);
  image->GetPointData()->SetScalars(
    withBorder ? withBorderOf(inside, grid.dimensions).Get() : inside);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.5);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  executor.runOnBackend([&contour]() { contour->Update(); });
  triangles_ = contour->GetOutput()->GetPolys();

  auto* middles = vtkFloatArray::SafeDownCast(contour->GetOutput()->GetPoints()->GetData());
  vertices_.resize(static_cast<std::size_t>(middles->GetNumberOfTuples()));
  runBlocks(
    vertices_.size(), verticesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        vertices_[i] = edgeAround(middles->GetPointer(static_cast<vtkIdType>(3 * i)));
      }
    },
    executor);
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
