// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/RunReport.h"

#include "commands/ReportParts.h"
#include "files/Formats.h"
#include "options/Options.h"
#include "program/ParallelRun.h"
#include "program/Threads.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberSurface.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{

constexpr const char* lengths[][2] = {{"largest_distance_from_input", "LargestDistanceFromInput"},
  {"mean_distance_from_input", "MeanDistanceFromInput"},
  {"largest_distance_to_input", "LargestDistanceToInput"},
  {"mean_distance_to_input", "MeanDistanceToInput"}, {"input_volume", "InputVolume"},
  {"volume", "Volume"}, {"largest_shape_error", "LargestShapeError"},
  {"mean_shape_error", "MeanShapeError"}};

constexpr const char* counts[][2] = {{"input_components", "InputComponents"},
  {"lost_components", "LostComponents"}, {"self_intersections", "SelfIntersections"}};

} // namespace

RunReport::RunReport(vtkWindingNumberGridAlgorithm& filter, const Options& options)
  : filter_(filter)
  , options_(options)
{
}

void RunReport::addExecution(double seconds)
{
  prepareSeconds_ += filter_.GetPrepareSeconds();
  expectedSeconds_ = filter_.GetExpectedSeconds();
  expectedMemory_ = filter_.GetExpectedMemory();
  evaluateSeconds_ += filter_.GetEvaluateSeconds();
  if (options_.verify > 0)
  {
    // Verification is the only long work apart from what the filter itself measures.
    verifySeconds_ +=
      std::max(0.0, seconds - filter_.GetPrepareSeconds() - filter_.GetEvaluateSeconds());
  }
  const vtkIdType samples = filter_.GetNumberOfVerifiedSamples();
  maxError_ = std::max(maxError_, filter_.GetMaxError());
  nearMaxError_ = std::max(nearMaxError_, filter_.GetNearMaxError());
  sumOfSquares_ += std::pow(filter_.GetRMSError(), 2) * static_cast<double>(samples);
  verified_ += samples;
  nearVerified_ += filter_.GetNumberOfNearVerifiedSamples();
  onSurface_ += filter_.GetNumberOfSamplesOnSurface();
  besidePoints_ += filter_.GetNumberOfSamplesBesidePoints();
  maxErrorBesidePoints_ = std::max(maxErrorBesidePoints_, filter_.GetMaxErrorBesidePoints());
  if (auto* field = vtkWindingNumberField::SafeDownCast(&filter_))
  {
    inside_ += field->GetNumberOfInsideSamples();
    for (int i = 0; i < 4; ++i)
    {
      sampleCounts_[i] += field->GetSampleCounts()[i];
    }
  }
}

void RunReport::warnOfPieces()
{
  auto* const field = vtkWindingNumberField::SafeDownCast(&filter_);
  if (!field || !(this->isInPieces() || !parallel::isAlone()))
  {
    return;
  }
  vtkIdType sums[4];
  std::transform(std::begin(sampleCounts_), std::end(sampleCounts_), sums,
    [](vtkIdType own) { return static_cast<vtkIdType>(parallel::sum(static_cast<double>(own))); });
  field->WarnOfPieces(sums);
}

/// Returns whether each piece of the result is written by itself.
bool RunReport::isInPieces() const
{
  return options_.pieces > 1 || (suffixOf(options_.output) == ".pvti" && !parallel::isAlone());
}

void RunReport::takeFidelity(vtkPolyData* surface)
{
  const auto valueOf = [surface](const char* name)
  {
    return surface->GetFieldData()->GetArray(name)->GetTuple1(0);
  };
  if (!surface->GetFieldData()->HasArray("SelfIntersections"))
  {
    return;
  }
  for (const auto& [key, name] : lengths)
  {
    if (!surface->GetFieldData()->HasArray(name))
    {
      continue; // without an offset and a shell there is no shape
    }
    const double value = valueOf(name);
    fidelity_[key] = std::isfinite(value) ? Json(value) : Json(nullptr);
  }
  for (const auto& [key, name] : counts)
  {
    fidelity_[key] = static_cast<long long>(valueOf(name));
  }
  fidelityInWords_ = vtkWindingNumberSurface::SafeDownCast(&filter_)->GetFidelityInWords();
}

void RunReport::print()
{
  this->gatherFigures();
  parallel::agreeOnFirst(
    [this]
    {
      const Json report = this->report();
      if (options_.json)
      {
        ::print(report);
      }
      else if (!options_.quiet)
      {
        ::print(this->summary(report));
      }
    });
}

/// Times and errors become the largest of all ranks, counts their sums.
void RunReport::gatherFigures()
{
  totalSeconds_ = stopwatch_.seconds();
  for (double* figure : {&readSeconds_, &prepareSeconds_, &evaluateSeconds_, &verifySeconds_,
         &writeSeconds_, &totalSeconds_, &maxError_, &nearMaxError_, &maxErrorBesidePoints_})
  {
    *figure = parallel::maximum(*figure);
  }
  for (vtkIdType* number : {&verified_, &nearVerified_, &onSurface_, &besidePoints_, &inside_})
  {
    *number = static_cast<vtkIdType>(parallel::sum(static_cast<double>(*number)));
  }
  sumOfSquares_ = parallel::sum(sumOfSquares_);
  peakMemories_ = parallel::allGather(static_cast<double>(peakMemory()));
}

/// Describes the image that the result lies on, in the coordinates of its file.
Json RunReport::describeLike() const
{
  vtkImageData* const image = like_.image;
  double first[3];
  image->TransformIndexToPhysicalPoint(
    image->GetExtent()[0], image->GetExtent()[2], image->GetExtent()[4], first);
  const bool hasCells = options_.cells;
  Json dimensions, origins, spacings, directions;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int points = image->GetDimensions()[axis];
    dimensions.push_back(hasCells ? std::max(1, points - 1) : points);
    origins.push_back(first[axis]);
    spacings.push_back(image->GetSpacing()[axis]);
  }
  for (int n = 0; n < 9; ++n)
  {
    directions.push_back(image->GetDirectionMatrix()->GetData()[n]);
  }
  return {{"dimensions", dimensions}, {"origin", origins}, {"spacing", spacings},
    {"directions", directions}, {"like", options_.like}, {"space", nameOf(like_.space)},
    {"association", hasCells ? "cells" : "points"}};
}

Json RunReport::describeGrid() const
{
  if (like_.image)
  {
    return this->describeLike();
  }
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_.GetGrid(voxels, firstSample, spacing);
  Json dimensions, origins, spacings, bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = firstSample[axis] - spacing[axis] / 2;
    dimensions.push_back(voxels[axis]);
    origins.push_back(options_.cells ? low : firstSample[axis]);
    spacings.push_back(spacing[axis]);
    bounds.push_back(low);
    bounds.push_back(low + voxels[axis] * spacing[axis]);
  }
  return {{"dimensions", dimensions}, {"origin", origins}, {"spacing", spacings},
    {"bounds", bounds}, {"association", options_.cells ? "cells" : "points"},
    {"why", filter_.GetResolutionReason()}};
}

/// How far distances reach, in the unit of the input.
double RunReport::distanceBand() const
{
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_.GetGrid(voxels, firstSample, spacing);
  return options_.distanceBand * *std::max_element(spacing, spacing + 3);
}

void RunReport::addErrors(Json& report) const
{
  // An error is null where the grid does not reach the source, so that nothing could be compared.
  const auto errorOf = [](vtkIdType samples, double error)
  {
    return samples > 0 ? Json(error) : Json(nullptr);
  };
  report["max_error"] = errorOf(verified_, maxError_);
  report["rms_error"] = errorOf(
    verified_, std::sqrt(sumOfSquares_ / std::max<double>(1, static_cast<double>(verified_))));
  report["near_max_error"] = errorOf(nearVerified_, nearMaxError_);
  report["on_surface"] = onSurface_;
  report["beside_points"] = besidePoints_;
  report["beside_points_max_error"] = errorOf(besidePoints_, maxErrorBesidePoints_);
}

Json RunReport::report() const
{
  Json seconds = {
    {"read", readSeconds_}, {"prepare", prepareSeconds_}, {"evaluate", evaluateSeconds_}};
  if (options_.verify > 0)
  {
    seconds["verify"] = verifySeconds_;
  }
  seconds["write"] = writeSeconds_;
  seconds["total"] = totalSeconds_;
  Json report = {{"input", describeInput(options_.input, filter_)},
    {"method", filter_.GetMethodUsed()}, {"why", filter_.GetMethodReason()},
    {"tolerance", options_.tolerance}, {"grid", this->describeGrid()},
    {"expected", {{"seconds", expectedSeconds_}, {"memory", expectedMemory_}}},
    {"seconds", seconds}, {"peak_memory", largestMemory(peakMemories_)},
    {"threads", threadsUsed(options_.threads)}};
  addRanks(report, peakMemories_);
  if (vtkWindingNumberField::SafeDownCast(&filter_))
  {
    // Pieces of points share the samples between them.
    report["inside"] = this->isInPieces() && !options_.cells ? Json(nullptr) : Json(inside_);
  }
  if (report["method"] == "rows")
  {
    report["cap_triangles"] = filter_.GetNumberOfCapTriangles();
  }
  if (options_.distance && output_.is_null())
  {
    report["distance_band"] =
      options_.distanceBand > 0 ? Json(this->distanceBand()) : Json(nullptr);
  }
  if (options_.verify > 0)
  {
    this->addErrors(report);
  }
  report.update(additions_);
  if (!output_.is_null())
  {
    report["output"] = output_;
  }
  if (!fidelity_.is_null())
  {
    report["fidelity"] = fidelity_;
  }
  return report;
}

std::string RunReport::errorsInWords(const Json& report) const
{
  if (verified_ + nearVerified_ == 0)
  {
    return besidePoints_ > 0 ? "all samples that could be compared lie near points"
                             : "no sample could be compared";
  }
  const std::string everywhere = verified_ > 0 ? "error max " + report["max_error"].dump() +
                                                   ", rms " + report["rms_error"].dump()
                                               : "no random sample could be compared";
  return everywhere + (nearVerified_ > 0
                          ? ", max near the surface " + report["near_max_error"].dump()
                          : ", no sample near the surface could be compared");
}

std::string RunReport::uncomparedInWords(const Json& report) const
{
  std::string text;
  const std::string all = std::to_string(verified_ + nearVerified_ + onSurface_ + besidePoints_);
  if (besidePoints_ > 0)
  {
    text += std::to_string(besidePoints_) + " of " + all +
            (besidePoints_ == 1 ? " samples lies " : " samples lie ") +
            "near a point, where w is large: error max " +
            report["beside_points_max_error"].dump() + "\n";
  }
  if (onSurface_ > 0)
  {
    const bool isSurface = report["input"]["kind"] == "surface";
    text += std::to_string(onSurface_) + " of " + all +
            (onSurface_ == 1 ? " samples lies " : " samples lie ") +
            (isSurface ? "on the surface, where either side is right"
                       : "at a point, where w has no value") +
            ", and were not compared\n";
  }
  return text;
}

std::string RunReport::summary(const Json& report) const
{
  const Json& input = report["input"];
  std::string text = options_.input + ": ";
  if (input["kind"] == "surface")
  {
    text += "surface, " + input["primitives"].dump() + " triangles, " +
            input["boundary_edges"].dump() + " boundary edges";
  }
  else
  {
    text += input["primitives"].dump() + " points, mean area " +
            shown(input["mean_area"].get<double>(), 3);
    if (input["normals_estimated"] == true)
    {
      const double percent = std::round(100 * input["clear_share"].get<double>());
      text += ", normals by " + input["normal_estimation"].get<std::string>() + ", clear at " +
              shown(percent, 3) + " %";
    }
  }
  const Json& grid = report["grid"]["dimensions"];
  const std::string why = report["grid"].value("why", "");
  const bool isCounted = report.contains("inside") && report["inside"].is_number();
  const std::string inside = isCounted ? report["inside"].dump() + " inside, " : "";
  text += "\nmethod " + report["method"].get<std::string>() + " (" +
          report["why"].get<std::string>() + "), " + grid[0].dump() + " x " + grid[1].dump() +
          " x " + grid[2].dump() + " voxels" + (why.empty() ? "" : " (" + why + ")") + ", " +
          inside + shown(report["seconds"]["total"].get<double>(), 3) + " s\n";
  if (options_.verify > 0)
  {
    text += this->errorsInWords(report) + "\n" + this->uncomparedInWords(report);
  }
  if (!fidelity_.is_null())
  {
    text += fidelityInWords_ + "\n";
  }
  text += "wrote " + options_.output;
  if (!output_.is_null())
  {
    text += ": " + output_["points"].dump() + " points, " + output_["cells"].dump() + " faces";
    if (output_.contains("parts"))
    {
      text += ", ";
      text += vtkWindingNumberSurfaceAlgorithm::SafeDownCast(&filter_)->GetSolidInWords();
    }
    if (output_.contains("filled_cavities"))
    {
      const bool isOne = output_["filled_cavities"] == 1;
      text +=
        ", " + output_["filled_cavities"].dump() + (isOne ? " cavity" : " cavities") + " filled";
    }
    if (output_.contains("distances_from"))
    {
      const bool isSource = output_["distances_from"] == "source";
      text += isSource ? ", distances from the input" : ", distances from the surface of its solid";
    }
  }
  return text;
}
