// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/ContentHash.h"
#include "support/Shapes.h"
#include "vtk/ErrorLog.h"
#include "vtk/ListedOptions.h"
#include "vtk/SphereCloud.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberClip.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <array>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>

/**
 * @file
 * Every option of filters/Options.def that a filter has: it is printed, it changes the hash that
 * ranks compare, and a filter that has run takes it as a new one does.
 */

namespace
{

/// Properties of readers, reports and surfaces of labels, which have no source that ranks share.
const std::set<std::string> ofOthers = {"ByLabel", "FixOrientation", "FaultThickness", "Columns",
  "ReadNormalsAndAreas", "ReadAllColumns", "KeepRows"};

/// Each rank may have its own of these.
const std::set<std::string> notHashed = {"NumberOfThreads", "LongestExpectedTime", "VerifySamples"};

/// Returns a value of an option that is not its default.
Value otherValue(const std::string& property)
{
  const Listed& option = listed().at(property);
  if (option.kind == "text")
  {
    const std::map<std::string, std::string> texts = {
      {"Mirror", "x=-2"}, {"FlatBase", "down"}, {"SheetSide", "up"}, {"Toward", "up"}};
    const auto found = texts.find(property);
    return Value(found == texts.end() ? "Other" : found->second);
  }
  if (option.kind == "integers" || option.kind == "numbers")
  {
    return Value(7);
  }
  double standard = 0;
  std::istringstream(option.standard) >> standard; // in any locale
  const bool isWhole = option.kind != "number";
  for (const double step : {isWhole ? 1 : 0.125, -1.0})
  {
    if (standard + step >= option.lowest && standard + step <= option.highest)
    {
      return Value(standard + step);
    }
  }
  ADD_FAILURE() << property;
  return Value(0.0);
}

/// Returns a value of an option that a new filter does not have. MendSource is off in fields.
template <class Property, class Filter> Value otherValueOf(Filter& filter, const std::string& name)
{
  return name == "MendSource" ? Value(1 - Property::get(filter, 0)) : otherValue(name);
}

/// A filter that shows the hash of its properties.
template <class Filter> class Opened : public Filter
{
public:
  static vtkSmartPointer<Opened> make()
  {
    auto* const made = new Opened;
    made->InitializeObjectBase();
    return vtkSmartPointer<Opened>::Take(made);
  }

  std::uint64_t hash()
  {
    winding::ContentHash hash;
    this->HashProperties(hash);
    return hash.value();
  }

  std::string printed()
  {
    std::ostringstream stream;
    this->PrintSelf(stream, vtkIndent());
    const std::string text = stream.str();
    return text.substr(text.find("Method: ")); // without times
  }
};

/// Sets a property of a fresh filter; returns whether it has it.
template <class Property, class Filter> bool changes(const std::string& name)
{
  SCOPED_TRACE(name);
  const auto filter = Opened<Filter>::make();
  const std::uint64_t hash = filter->hash();
  const std::string printed = filter->printed();
  const vtkMTimeType time = filter->GetMTime();
  auto& plain = *static_cast<Filter*>(filter);
  if (!Property::set(plain, otherValueOf<Property>(plain, name), 0))
  {
    return false;
  }
  EXPECT_GT(filter->GetMTime(), time);
  EXPECT_NE(filter->printed(), printed);
  EXPECT_EQ(filter->hash() == hash, notHashed.count(name) > 0);
  return true;
}

template <class Filter> void expectAllCount(std::set<std::string>& found, std::size_t& count)
{
  SCOPED_TRACE(typeid(Filter).name());
#define CHANGES(name)                                                                              \
  if (changes<Of##name, Filter>(#name))                                                            \
  {                                                                                                \
    found.insert(#name);                                                                           \
    ++count;                                                                                       \
  }
  PROPERTIES(CHANGES)
}

/// A box without its lid, whose faces look inward, and a loose sheet in it.
vtkSmartPointer<vtkPolyData> openBox()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  for (int corner = 0; corner < 8; ++corner)
  {
    points->InsertNextPoint(corner % 2, 1.5 * (corner / 2 % 2), 2.0 * (corner / 4));
  }
  for (const double z : {0.5, 0.51})
  {
    for (const auto& [x, y] : {std::pair(0.3, 0.4), std::pair(0.7, 0.4), std::pair(0.5, 0.9)})
    {
      points->InsertNextPoint(x, y, z);
    }
  }
  for (const auto& ids :
    {std::array<vtkIdType, 4>{0, 1, 3, 2}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}})
  {
    polygons->InsertNextCell(4, ids.data());
  }
  polygons->InsertNextCell({8, 9, 10});
  polygons->InsertNextCell({11, 13, 12});
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(points);
  box->SetPolys(polygons);
  return box;
}

/// An uneven cloud with normals, and with others.
vtkSmartPointer<vtkPolyData> unevenCloud()
{
  const vtkSmartPointer<vtkPolyData> cloud = sphereCloud(300, 1);
  vtkNew<vtkDoubleArray> other;
  other->SetName("Other");
  other->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < cloud->GetNumberOfPoints(); ++id)
  {
    double place[3];
    cloud->GetPoint(id, place);
    other->InsertNextTuple3(place[0], place[1], place[2] + 0.3);
    cloud->GetPoints()->SetPoint(id, place[0], 1.3 * place[1], place[2] * (1 + 0.3 * place[2]));
  }
  cloud->GetPointData()->AddArray(other);
  return cloud;
}

/// Returns all arrays and the grid that a run of a filter gives, in bytes, or its error.
std::string outcomeOf(vtkWindingNumberField* filter)
{
  ErrorLog log(filter);
  filter->Update();
  filter->RemoveAllObservers();
  // Errors begin with addresses.
  const std::size_t end = log.errors().find("): ");
  std::string text = end == std::string::npos ? "" : log.errors().substr(end);
  vtkImageData* const image = filter->GetOutput();
  if (image->GetNumberOfPoints() == 0)
  {
    return text;
  }
  const auto add = [&text](const void* bytes, std::size_t count)
  {
    text.append(static_cast<const char*>(bytes), count);
  };
  add(image->GetExtent(), 6 * sizeof(int));
  add(image->GetOrigin(), 3 * sizeof(double));
  add(image->GetSpacing(), 3 * sizeof(double));
  for (vtkDataSetAttributes* data : {static_cast<vtkDataSetAttributes*>(image->GetPointData()),
         static_cast<vtkDataSetAttributes*>(image->GetCellData())})
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = data->GetArray(i);
      text += array->GetName();
      add(array->GetVoidPointer(0), static_cast<std::size_t>(array->GetNumberOfValues()) *
                                      static_cast<std::size_t>(array->GetDataTypeSize()));
    }
  }
  return text;
}

vtkSmartPointer<vtkWindingNumberField> fieldOf(vtkPolyData* source)
{
  auto filter = vtkSmartPointer<vtkWindingNumberField>::New();
  filter->SetInputData(source);
  filter->SetResolution(12);
  filter->GenerateInsideOn();
  filter->GenerateSignedDistanceOn();
  const bool hasNormals = source->GetPointData()->GetNormals() != nullptr;
  filter->SetEstimateNormals(source->GetNumberOfPolys() == 0 && !hasNormals);
  return filter;
}

/// Sets a property of a filter that has run, and of a new one, and compares what they give. Notes
/// the property where it changes that.
template <class Property>
void setLater(vtkPolyData* source, const std::string& name, std::string& changing)
{
  SCOPED_TRACE(name);
  const auto warm = fieldOf(source), fresh = fieldOf(source);
  const std::string before = outcomeOf(warm);
  Property::set(*warm, otherValueOf<Property>(*warm, name), 0);
  Property::set(*fresh, otherValueOf<Property>(*fresh, name), 0);
  const std::string after = outcomeOf(warm);
  EXPECT_TRUE(after == outcomeOf(fresh));
  changing += after == before ? "" : " " + name;
}

} // namespace

TEST(Options, OfAllFiltersArePrintedAndHashed)
{
  std::set<std::string> found;
  std::size_t count = 0;
  expectAllCount<vtkWindingNumberField>(found, count);
  expectAllCount<vtkWindingNumberSurface>(found, count);
  expectAllCount<vtkWindingNumberBoolean>(found, count);
  expectAllCount<vtkWindingNumberLabels>(found, count);
  expectAllCount<vtkWindingNumberProbe>(found, count);
  expectAllCount<vtkWindingNumberClip>(found, count);
  for (const auto& [property, option] : listed())
  {
    EXPECT_EQ(found.count(property) == 0, ofOthers.count(property) > 0) << property;
  }
  EXPECT_EQ(count, 236u); // measured: of six filters
}

TEST(Options, OfOperandsAreHashed)
{
  using Set = void (*)(vtkWindingNumberBoolean&);
  const Set sets[] = {[](vtkWindingNumberBoolean&) {},
    [](vtkWindingNumberBoolean& filter) { filter.SetOperandThreshold(0, 0.4); },
    [](vtkWindingNumberBoolean& filter) { filter.SetOperandThreshold(1, 0.4); },
    [](vtkWindingNumberBoolean& filter) { filter.SetOperandThreshold(1, 0.6); },
    [](vtkWindingNumberBoolean& filter) { filter.SetOperandInsideRule(0, 1); },
    [](vtkWindingNumberBoolean& filter) { filter.SetOperandInsideRule(1, 1); },
    [](vtkWindingNumberBoolean& filter) { filter.SetOperandInsideRule(1, 2); },
    [](vtkWindingNumberBoolean& filter) { filter.SetInputName(0, "a"); },
    [](vtkWindingNumberBoolean& filter) { filter.SetInputName(1, "a"); },
    [](vtkWindingNumberBoolean& filter) { filter.SetInputName(0, "b"); },
    [](vtkWindingNumberBoolean& filter)
    {
      filter.SetOtherName(0, "a");
    }};
  std::set<std::uint64_t> hashes;
  for (const Set& set : sets)
  {
    const auto filter = Opened<vtkWindingNumberBoolean>::make();
    set(*filter);
    hashes.insert(filter->hash());
  }
  EXPECT_EQ(hashes.size(), std::size(sets));
}

TEST(Options, AreTakenByAFieldThatHasRun)
{
  const vtkSmartPointer<vtkPolyData> mesh = openBox(), cloud = unevenCloud(), bare = unevenCloud();
  bare->GetPointData()->Initialize();
  std::string ofMesh, ofCloud, ofBare;
#define SET_LATER(name)                                                                            \
  setLater<Of##name>(mesh, #name, ofMesh);                                                         \
  setLater<Of##name>(cloud, #name, ofCloud);                                                       \
  setLater<Of##name>(bare, #name, ofBare);
  PROPERTIES(SET_LATER)
  // These change something, so that the comparison is of use.
  EXPECT_EQ(ofMesh,
    " SourceAsPoints MendSource OrientFaces IgnoreOpenParts Mirror FlatBase SheetSide "
    "WeldTolerance Resolution "
    "VoxelSize SamplingDimensions UseInputBounds Padding OutputAssociation InsideRule Coverage "
    "GenerateWindingNumber DistanceBand ResultArrayName OutputScalarType GenerateNearestCells");
  EXPECT_EQ(ofCloud,
    " Method Regularization Mirror NormalsArray PointAreaMethod Resolution VoxelSize "
    "SamplingDimensions UseInputBounds Padding OutputAssociation WindingThreshold InsideRule "
    "Coverage GenerateWindingNumber DistanceBand ResultArrayName OutputScalarType "
    "GenerateNearestCells");
  EXPECT_EQ(ofBare,
    " Method Regularization Mirror NormalsArray Toward PointAreaMethod NumberOfNeighbors "
    "Resolution VoxelSize SamplingDimensions UseInputBounds Padding OutputAssociation "
    "WindingThreshold InsideRule Coverage GenerateWindingNumber DistanceBand ResultArrayName "
    "OutputScalarType GenerateNearestCells");
}
