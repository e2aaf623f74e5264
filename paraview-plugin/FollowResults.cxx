// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FollowResults.h"

#include "vtkCollection.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkProcessModule.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

using Extent = std::array<int, 6>;

bool isEmpty(const Extent& extent)
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

bool isOfPlugin(vtkSMProxy* proxy)
{
  const char* const name = proxy ? proxy->GetVTKClassName() : nullptr;
  return name && std::strncmp(name, "vtkWindingNumber", 16) == 0;
}

/// Returns the array of points or cells of that name; null if the data has none.
vtkPVArrayInformation* arrayOf(vtkPVDataInformation* data, const char* name)
{
  vtkPVArrayInformation* const ofPoints =
    data->GetPointDataInformation()->GetArrayInformation(name);
  return ofPoints ? ofPoints : data->GetCellDataInformation()->GetArrayInformation(name);
}

/// Returns the name of the active array of the points of data, or "".
std::string activeScalarsOf(vtkPVDataInformation* data)
{
  vtkPVArrayInformation* const scalars =
    data->GetPointDataInformation()->GetAttributeInformation(vtkDataSetAttributes::SCALARS);
  return scalars && scalars->GetName() ? scalars->GetName() : "";
}

/// Returns the colours of an array, which are made if nobody has asked for them.
vtkSMProxy* colorsOf(vtkSMSourceProxy* source, const char* name)
{
  vtkNew<vtkSMTransferFunctionManager> manager;
  return manager->GetColorTransferFunction(name, source->GetSessionProxyManager());
}

/// Spreads the colours of signed distances evenly around 0.
class DistanceColors
{
public:
  void follow(vtkSMSourceProxy* source, vtkPVDataInformation* data)
  {
    constexpr const char* name = "SignedDistance";
    vtkPVArrayInformation* const array = arrayOf(data, name);
    if (!array)
    {
      return;
    }
    double range[2];
    array->GetComponentFiniteRange(0, range);
    const double reach = std::max(std::abs(range[0]), std::abs(range[1]));
    vtkSMProxy* const colors = colorsOf(source, name);
    double present[2];
    const bool isOwn =
      colors && vtkSMTransferFunctionProxy::GetRange(colors, present) && present[1] == reach_;
    if (isOwn && reach > 0 && reach != reach_)
    {
      vtkSMTransferFunctionProxy::RescaleTransferFunction(colors, -reach, reach);
      reach_ = reach;
    }
  }

private:
  double reach_ = 1; ///< of the range that was set last: ColorDefaults.cxx begins with −1 to 1
};

/// An array of categories, and the property of a filter with their numbers and names.
struct Categories
{
  const char* array;
  const char* legend;
  bool hasOutside; ///< whether 0 is outside, and is not drawn
};

constexpr Categories allCategories[] = {
  {"Label", "LabelLegend", true}, {"Operand", "OperandLegend", false}};

/// Gives the categories of a legend a colour each, and their names, unless a map has been given
/// these before: `named` has what each map was given last. So what its user changes stays.
void nameCategories(vtkSMProxy* colors, vtkSMProperty* legend, bool hasOutside,
  std::map<vtkTypeUInt32, std::vector<std::string>>& named)
{
  // The 20 colours are Tableau's, the light ones last.
  constexpr double palette[][3] = {{0.122, 0.467, 0.706}, {1, 0.498, 0.055}, {0.173, 0.627, 0.173},
    {0.839, 0.153, 0.157}, {0.58, 0.404, 0.741}, {0.549, 0.337, 0.294}, {0.89, 0.467, 0.761},
    {0.498, 0.498, 0.498}, {0.737, 0.741, 0.133}, {0.09, 0.745, 0.812}, {0.682, 0.78, 0.91},
    {1, 0.733, 0.471}, {0.596, 0.875, 0.541}, {1, 0.596, 0.588}, {0.773, 0.69, 0.835},
    {0.769, 0.612, 0.58}, {0.969, 0.714, 0.824}, {0.78, 0.78, 0.78}, {0.859, 0.859, 0.553},
    {0.62, 0.855, 0.898}};
  std::vector<std::string> annotations;
  std::vector<double> rgb, opacities;
  if (hasOutside)
  {
    annotations = {"0", "outside"};
    rgb = {0.93, 0.93, 0.93};
    opacities = {0};
  }
  std::istringstream lines(vtkSMPropertyHelper(legend).GetAsString());
  for (std::string number, name; std::getline(lines, number, '\t') && std::getline(lines, name);)
  {
    const double* const color =
      palette[(annotations.size() / 2 + !hasOutside) % std::size(palette)];
    annotations.insert(annotations.end(), {number, name});
    rgb.insert(rgb.end(), color, color + 3);
    opacities.push_back(1);
  }
  std::vector<std::string>& given = named[colors->GetGlobalID()];
  if (given == annotations || opacities.size() == (hasOutside ? 1 : 0))
  {
    return;
  }
  given = annotations;
  vtkSMPropertyHelper words(colors, "Annotations");
  words.SetNumberOfElements(static_cast<unsigned int>(annotations.size()));
  for (std::size_t i = 0; i < annotations.size(); ++i)
  {
    words.Set(static_cast<unsigned int>(i), annotations[i].c_str());
  }
  const auto set = [colors](const char* name, const std::vector<double>& values)
  {
    vtkSMPropertyHelper(colors, name).Set(values.data(), static_cast<unsigned int>(values.size()));
  };
  vtkSMPropertyHelper(colors, "IndexedLookup").Set(1);
  set("IndexedColors", rgb);
  set("IndexedOpacities", opacities);
  vtkSMPropertyHelper(colors, "EnableOpacityMapping").Set(1);
  colors->UpdateVTKObjects();
}

/// Gives results with categories a map of colours each, with the names of these.
class Legends
{
public:
  /// Looks at a representation that a view shows.
  void follow(vtkSMPVRepresentationProxy* representation, vtkSMViewProxy* view)
  {
    if (!representation || !representation->GetProperty("ColorArrayName"))
    {
      return;
    }
    vtkSMProxy* const source = vtkSMPropertyHelper(representation, "Input", true).GetAsProxy();
    const vtkSMPropertyHelper helper(representation, "ColorArrayName");
    const char* const name = helper.GetInputArrayNameToProcess();
    for (const auto& [array, legend, hasOutside] : allCategories)
    {
      vtkSMProperty* const names = isOfPlugin(source) ? source->GetProperty(legend) : nullptr;
      if (!names || !name || std::strcmp(name, array) != 0)
      {
        continue;
      }
      if (separated_.insert(representation->GetGlobalID()).second)
      {
        separate(representation, view, name, helper.GetInputArrayAssociation());
      }
      if (auto* colors = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy())
      {
        nameCategories(colors, names, hasOutside, named_);
      }
    }
  }

  /// Names the categories of the maps that scripts find by the names of arrays.
  void follow(vtkSMSourceProxy* source)
  {
    for (const auto& [array, legend, hasOutside] : allCategories)
    {
      vtkSMProperty* const names = source->GetProperty(legend);
      vtkSMProxy* const colors = names ? colorsOf(source, array) : nullptr;
      if (colors)
      {
        nameCategories(colors, names, hasOutside, named_);
      }
    }
  }

private:
  /// Gives a representation a map of its own, which its user may give up again.
  static void separate(vtkSMPVRepresentationProxy* representation, vtkSMViewProxy* view,
    const std::string& array, int association)
  {
    const bool hasBar = representation->IsScalarBarVisible(view);
    vtkSMPropertyHelper(representation, "UseSeparateColorMap").Set(1);
    representation->SetScalarColoring(array.c_str(), association);
    if (hasBar)
    {
      representation->SetScalarBarVisibility(view, true);
    }
    vtkNew<vtkSMTransferFunctionManager> manager;
    manager->UpdateScalarBars(view, vtkSMTransferFunctionManager::HIDE_UNUSED_SCALAR_BARS);
  }

  std::set<vtkTypeUInt32> separated_; ///< representations
  std::map<vtkTypeUInt32, std::vector<std::string>> named_;
};

/// A change of a representation that waits for the end of its view's update, which it would break.
struct Change
{
  vtkWeakPointer<vtkSMProxy> representation;
  const char* type = nullptr; ///< null: stays
  std::optional<int> slice;
  std::string scalars; ///< to be coloured by; empty: stays
};

/// Keeps the slices of an image where they are in its bounds.
class Slices
{
public:
  /// Returns what a representation needs for the new result. Without samples `extent` is empty, and
  /// a slice becomes an outline, for one of nothing would be an error at each render.
  Change changeOf(vtkSMProxy* representation, const Extent& extent, const std::string& scalars)
  {
    Change change;
    change.representation = representation;
    const vtkTypeUInt32 number = representation->GetGlobalID();
    const bool isSlice =
      std::strcmp(vtkSMPropertyHelper(representation, "Representation").GetAsString(), "Slice") ==
      0;
    int present = vtkSMPropertyHelper(representation, "Slice").GetAsInt();
    const auto outlined = outlined_.find(number);
    if (isEmpty(extent))
    {
      if (isSlice)
      {
        change.type = "Outline";
        outlined_[number] = present;
      }
      return change;
    }
    bool hasMoved = extent != extent_;
    // ParaView has set the slice to the first layer meanwhile.
    if (outlined != outlined_.end())
    {
      change.type = "Slice";
      present = outlined->second;
      outlined_.erase(outlined);
      hasMoved = true;
    }
    if (isEmpty(extent_) && hasFailed_)
    {
      // It has found nothing to colour by either, as this is the first result.
      change.type = "Slice";
      change.scalars = scalars;
    }
    if (hasMoved && (!isEmpty(extent_) || change.type))
    {
      constexpr int planes[] = {4, 0, 2}; // first places in extents, for XY, YZ and XZ
      constexpr int xyPlane = 5;          // VTK_XY_PLANE has another name since VTK 9.6
      const int first = planes[std::clamp(
        vtkSMPropertyHelper(representation, "SliceMode").GetAsInt() - xyPlane, 0, 2)];
      const auto layers = [first](const Extent& of)
      {
        return static_cast<double>(of[first + 1] - of[first] + 1);
      };
      const double share =
        isEmpty(extent_) ? 0.5 : (present - extent_[first] + 0.5) / layers(extent_);
      const int moved = extent[first] + static_cast<int>(std::floor(share * layers(extent)));
      change.slice = std::clamp(moved, extent[first], extent[first + 1]);
    }
    return change;
  }

  void setExtent(const Extent& extent)
  {
    extent_ = isEmpty(extent) ? extent_ : extent;
    hasFailed_ = isEmpty(extent);
  }

private:
  bool hasFailed_ = false;                ///< whether the last result had no samples
  Extent extent_ = {0, -1, 0, -1, 0, -1}; ///< of the last image that had samples
  /// The slices of representations that are outlines instead.
  std::map<vtkTypeUInt32, int> outlined_;
};

/// Hears of new filters, of their results, and of views that are up to date.
class Follower : public vtkCommand
{
public:
  vtkTypeMacro(Follower, vtkCommand);
  static Follower* New() { return new Follower; }

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    if (event == RegisterEvent)
    {
      const auto* const registered =
        static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
      if (registered->Type == vtkSMProxyManager::RegisteredProxyInformation::PROXY &&
          isOfPlugin(registered->Proxy))
      {
        this->observe(registered->Proxy);
        this->observeViews(registered->Proxy->GetSessionProxyManager());
      }
      else if (vtkSMViewProxy::SafeDownCast(registered->Proxy))
      {
        this->observe(registered->Proxy);
      }
    }
    else if (event == DeleteEvent)
    {
      slices_.erase(caller);
    }
    else if (auto* view = vtkSMViewProxy::SafeDownCast(caller))
    {
      this->applyChanges(view);
      vtkSMPropertyHelper representations(view, "Representations", true);
      for (unsigned int i = 0; i < representations.GetNumberOfElements(); ++i)
      {
        legends_.follow(
          vtkSMPVRepresentationProxy::SafeDownCast(representations.GetAsProxy(i)), view);
      }
    }
    else if (auto* source = vtkSMSourceProxy::SafeDownCast(caller))
    {
      this->follow(source);
    }
  }

private:
  void observe(vtkSMProxy* proxy)
  {
    if (!proxy->HasObserver(UpdateDataEvent, this))
    {
      proxy->AddObserver(UpdateDataEvent, this);
      proxy->AddObserver(DeleteEvent, this);
    }
  }

  void observeViews(vtkSMSessionProxyManager* manager)
  {
    vtkNew<vtkCollection> views;
    manager->GetProxies("views", views);
    for (int i = 0; i < views->GetNumberOfItems(); ++i)
    {
      if (auto* const view = vtkSMViewProxy::SafeDownCast(views->GetItemAsObject(i)))
      {
        this->observe(view);
      }
    }
  }

  void follow(vtkSMSourceProxy* source)
  {
    source->UpdatePropertyInformation();
    if (source->GetNumberOfOutputPorts() == 0)
    {
      return;
    }
    vtkPVDataInformation* const data = source->GetDataInformation(0);
    this->followSlices(source, data);
    distances_.follow(source, data);
    legends_.follow(source);
  }

  void followSlices(vtkSMSourceProxy* source, vtkPVDataInformation* data)
  {
    Extent extent = {0, -1, 0, -1, 0, -1};
    if (data->GetNumberOfPoints() > 0)
    {
      data->GetExtent(extent.data());
    }
    const std::string scalars = activeScalarsOf(data);
    for (unsigned int i = 0; i < source->GetNumberOfConsumers(); ++i)
    {
      vtkSMProxy* const consumer = source->GetConsumerProxy(i);
      if (consumer && consumer->GetProperty("Slice") && consumer->GetProperty("Representation"))
      {
        const Change change = slices_[source].changeOf(consumer, extent, scalars);
        if (change.type || change.slice)
        {
          changes_.push_back(change);
        }
      }
    }
    slices_[source].setExtent(extent);
  }

  void applyChanges(vtkSMViewProxy* view)
  {
    if (changes_.empty())
    {
      return;
    }
    for (const Change& change : std::exchange(changes_, {}))
    {
      if (change.representation && change.type)
      {
        vtkSMPropertyHelper(change.representation, "Representation").Set(change.type);
      }
      if (change.representation && change.slice)
      {
        vtkSMPropertyHelper(change.representation, "Slice").Set(*change.slice);
      }
      if (change.representation)
      {
        change.representation->UpdateVTKObjects();
      }
      auto* const shown = vtkSMPVRepresentationProxy::SafeDownCast(change.representation);
      if (shown && !change.scalars.empty())
      {
        shown->SetScalarColoring(change.scalars.c_str(), vtkDataObject::POINT);
      }
    }
    view->Update();
  }

  std::map<vtkObject*, Slices> slices_; ///< by source
  std::vector<Change> changes_;
  DistanceColors distances_;
  Legends legends_;
};

} // namespace

void followResults()
{
  static bool isFollowing = false;
  const int type = vtkProcessModule::GetProcessType();
  const bool isServer = type == vtkProcessModule::PROCESS_SERVER ||
                        type == vtkProcessModule::PROCESS_DATA_SERVER ||
                        type == vtkProcessModule::PROCESS_RENDER_SERVER;
  vtkSMProxyManager* const manager = isServer ? nullptr : vtkSMProxyManager::GetProxyManager();
  if (manager && !isFollowing)
  {
    vtkNew<Follower> follower;
    manager->AddObserver(vtkCommand::RegisterEvent, follower);
    isFollowing = true;
  }
}

} // namespace winding
