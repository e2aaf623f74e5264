#include "commands/FidelityReport.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace
{

constexpr const char* lengths[][2] = {{"largest_distance_from_input", "LargestDistanceFromInput"},
  {"mean_distance_from_input", "MeanDistanceFromInput"},
  {"largest_distance_to_input", "LargestDistanceToInput"},
  {"mean_distance_to_input", "MeanDistanceToInput"}, {"input_volume", "InputVolume"},
  {"volume", "Volume"}};

constexpr const char* counts[][2] = {{"input_components", "InputComponents"},
  {"lost_components", "LostComponents"}, {"self_intersections", "SelfIntersections"}};

} // namespace

Json describeFidelity(vtkPolyData* surface)
{
  const auto valueOf = [surface](const char* name)
  {
    return surface->GetFieldData()->GetArray(name)->GetTuple1(0);
  };
  if (!surface->GetFieldData()->HasArray("SelfIntersections"))
  {
    return nullptr;
  }
  Json fidelity;
  for (const auto& [key, name] : lengths)
  {
    const double value = valueOf(name);
    fidelity[key] = std::isfinite(value) ? Json(value) : Json(nullptr);
  }
  for (const auto& [key, name] : counts)
  {
    fidelity[key] = static_cast<long long>(valueOf(name));
  }
  return fidelity;
}

std::string fidelityInWords(const Json& fidelity)
{
  const auto number = [&fidelity](const char* key)
  {
    return fidelity[key].is_null() ? std::string("unknown") : shown(fidelity[key].get<double>(), 3);
  };
  return "distance from the input max " + number("largest_distance_from_input") + ", mean " +
         number("mean_distance_from_input") + "; to the input max " +
         number("largest_distance_to_input") + ", mean " + number("mean_distance_to_input") +
         "\nvolume " + number("volume") + ", of the input " + number("input_volume") + "; " +
         fidelity["lost_components"].dump() + " of " + fidelity["input_components"].dump() +
         " parts lost; " + fidelity["self_intersections"].dump() + " self-intersections";
}
