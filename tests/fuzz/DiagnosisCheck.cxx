// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Refusal.h"
#include "distance/PrimitivesNear.h"
#include "rays/SampleLines.h"
#include "sums/ReferenceSum.h"
#include "support/DiagnosisTime.h"
#include "support/Serial.h"
#include "support/Shuffled.h"
#include "surface/Boundary.h"

#include <cmath>
#include <sstream>

/**
 * @file
 * The faults of a source depend on the set of its triangles. Lines through points of a closed
 * surface give its winding numbers there. Diagnosis takes a tenth of the time of the answer and
 * 2 ms, with a margin.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;
using shapes::Point;
using shapes::serial;

std::string faultsOf(const Mesh& mesh)
{
  std::string faults;
  for (const Message& message :
    Field::build(viewsOf(mesh), FieldOptions(), serial)->diagnosis().ofSource(serial))
  {
    faults += message.fault + "; " + message.facts + "\n";
  }
  return faults;
}

/// Compares what lines through points tell with the definition.
std::string checkLines(const Surface& surface)
{
  constexpr std::size_t points = 8;
  const SurfaceSamples samples = sampleSurface(surface, points, serial);
  const std::vector<SampleLine> lines = linesThrough(surface, samples.points, samples, serial);
  const bool isClosed = boundaryChain(surface, serial).edges.empty();
  const double size = surface.bounds.sizes().maxCoeff();
  const double step = 1e-5 * size;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const SampleLine& line = lines[i];
    if (isClosed && !line.isClear())
    {
      return "a line through a closed surface is not clear";
    }
    const SurfaceSample& sample = samples.points[i];
    const Point before = sample.position + step * sample.normal;
    const Point behind = sample.position - step * sample.normal;
    if (!isClosed || trianglesNear(surface, sample.position, 4 * step) > 1)
    {
      continue;
    }
    if (std::abs(referenceSum<double>(surface, before) - line.before) > 1e-3 ||
        std::abs(referenceSum<double>(surface, behind) - line.behind) > 1e-3)
    {
      return "a line has other winding numbers than the sum";
    }
  }
  return {};
}

} // namespace

std::string checkDiagnosis(Choices& choices)
{
  const Mesh mesh = randomMesh(choices, 400);
  try
  {
    const std::string faults = faultsOf(mesh);
    const Mesh other = shapes::shuffled(mesh, [&choices](std::size_t n)
      { return static_cast<std::size_t>(choices.below(static_cast<int>(n))); });
    if (faultsOf(other) != faults)
    {
      return "faults depend on the order: " + faults + " or " + faultsOf(other);
    }
    const Surface surface = shapes::clean(mesh);
    const Point sizes = surface.bounds.sizes();
    // Points are rounded, by more than a step in a source that is far from the origin.
    const bool isOrdinary = !surface.bounds.isEmpty() &&
                            surface.bounds.min().cwiseAbs().maxCoeff() < 1e3 * sizes.maxCoeff() &&
                            sizes.maxCoeff() > 0;
    return isOrdinary ? checkLines(surface) : std::string();
  }
  catch (const Refusal&)
  {
    return {};
  }
}

std::string checkDiagnosisTime(Choices& choices)
{
  const Mesh mesh = randomMesh(choices, choices.oneIn(4) ? 20000 : 2000);
  const int resolution = 2 + choices.below(63);
  constexpr int attempts = 4;
  constexpr double margin = 2;
  try
  {
    const auto time = shapes::leastDiagnosisTime(viewsOf(mesh), resolution, attempts);
    const double allowed = margin * (0.1 * time.answer + 2e-3);
    std::ostringstream failure;
    failure << "diagnosis takes " << time.diagnosis << " s, more than " << allowed << ": "
            << mesh.triangles.size() << " triangles, resolution " << resolution;
    return time.diagnosis <= allowed ? std::string() : failure.str();
  }
  catch (const Refusal&)
  {
    return {};
  }
}

} // namespace fuzz
