// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * The options of filters/Options.def, and their properties in filters.
 */

/// A value for a setter, whatever type it takes.
class Value
{
public:
  explicit Value(double number)
    : number_(number)
  {
    integers_.fill(std::isfinite(number) ? static_cast<int>(number) : 0);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
    {
      numbers_[i] = i % 2 == 0 ? -number : number;
    }
  }
  explicit Value(std::string text)
    : text_(std::move(text))
  {
  }

  operator int() const { return static_cast<int>(number_); }
  operator double() const { return number_; }
  operator bool() const { return number_ != 0; }
  operator const char*() const { return text_.c_str(); }
  operator const int*() const { return integers_.data(); }
  operator const double*() const { return numbers_.data(); }

private:
  double number_ = 0;
  std::string text_;
  std::array<int, 3> integers_ = {};
  std::array<double, 6> numbers_ = {};
};

/// Sets a property of a filter that has it, and returns whether it does; gets a property that is a
/// number, and NaN for any other.
#define PROPERTY(name)                                                                             \
  struct Of##name                                                                                  \
  {                                                                                                \
    template <class Filter>                                                                        \
    static auto set(Filter& filter, const Value& value, int)                                       \
      -> decltype(filter.Set##name(value), bool())                                                 \
    {                                                                                              \
      filter.Set##name(value);                                                                     \
      return true;                                                                                 \
    }                                                                                              \
    template <class Filter> static bool set(Filter&, const Value&, long) { return false; }         \
    template <class Filter>                                                                        \
    static auto get(Filter& filter, int) -> decltype(static_cast<double>(filter.Get##name()))      \
    {                                                                                              \
      return filter.Get##name();                                                                   \
    }                                                                                              \
    template <class Filter> static double get(Filter&, long) { return std::nan(""); }              \
  };
#define PROPERTIES(apply)                                                                          \
  apply(Method) apply(Tolerance) apply(Regularization) apply(NumberOfThreads)                      \
    apply(LongestExpectedTime) apply(SourceAsPoints) apply(UseSurfaceCells) apply(MendSource)      \
      apply(OrientFaces) apply(IgnoreOpenParts) apply(Mirror) apply(FlatBase) apply(SheetSide)     \
        apply(WeldTolerance) apply(SourceDistribution) apply(NormalsArray) apply(EstimateNormals)  \
          apply(NormalEstimation) apply(Toward) apply(PointAreaMethod) apply(PointArea)            \
            apply(AreaArray) apply(NumberOfNeighbors) apply(Resolution) apply(VoxelSize)           \
              apply(SamplingDimensions) apply(UseInputBounds) apply(BoundsOverAllTimes)            \
                apply(SamplingBounds) apply(Padding) apply(OutputAssociation)                      \
                  apply(WindingThreshold) apply(InsideRule) apply(InsideOut) apply(Coverage)       \
                    apply(CoverageSamples) apply(UnionOverAllTimes) apply(GenerateWindingNumber)   \
                      apply(GenerateInside) apply(GenerateSignedDistance) apply(GenerateFraction)  \
                        apply(DistanceBand) apply(ResultArrayName) apply(InsideArrayName)          \
                          apply(OutputScalarType) apply(VerifySamples) apply(Features)             \
                            apply(GenerateTriangles) apply(CloseBorder) apply(FillCavities)        \
                              apply(GapWidth) apply(Offset) apply(Shell) apply(ShellSide)          \
                                apply(GenerateNormals) apply(OutputPointsPrecision)                \
                                  apply(GenerateDistanceToInput) apply(TransferAttributes)         \
                                    apply(GenerateNearestCells) apply(GenerateImage)               \
                                      apply(FidelitySamples) apply(Operation) apply(OverlapRule)   \
                                        apply(RegionArray) apply(LabelOffset)                      \
                                          apply(GenerateSolidCount) apply(CoverageArrays)          \
                                            apply(ProbeAssociation) apply(ExtractInside)
PROPERTIES(PROPERTY)

/// An option as the list has it, with the numbers and constants of its choices.
struct Listed
{
  std::string kind, standard;
  double lowest, highest;
  std::vector<std::pair<int, std::string>> choices;
};

/// Returns the options of the list by their properties.
inline const std::map<std::string, Listed>& listed()
{
  static const std::map<std::string, Listed> options = []
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::map<std::string, Listed> made;
    Listed* last = nullptr;
#define OPTION(parameter, property, kind, standard, lowest, highest, ...)                          \
  last = &made[property];                                                                          \
  *last = {#kind, standard, static_cast<double>(lowest), static_cast<double>(highest), {}};
#define CHOICE(parameter, number, constant, ...) last->choices.emplace_back(number, constant);
#define OTHER(...)
#include "Options.def"
#undef OPTION
#undef CHOICE
#undef OTHER
    return made;
  }();
  return options;
}
