// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/BenchOptions.h"
#include "laboratory/BenchSubjects.h"
#include "laboratory/Meshes.h"
#include "laboratory/ThreadExecutor.h"
#include "laboratory/Timing.h"
#include "laboratory/VtkContestants.h"
#include "program/Interrupt.h"
#include "program/Threads.h"

#include "base/FieldOutput.h"
#include "base/Refusal.h"
#include "base/Views.h"
#include "field/Field.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace
{

/// The most samples of a contest whose answers are checked.
constexpr std::size_t mostChecked = 2000;

/// Samples of a contest, evenly chosen, and the direct sums there.
struct Checked
{
  std::vector<std::size_t> samples;
  std::vector<double> windingNumbers;
};

Checked directSums(const Contest& contest, const winding::Field& direct)
{
  Checked checked;
  const std::size_t count = std::min(contest.count, mostChecked);
  std::vector<Eigen::Vector3d> positions;
  for (std::size_t i = 0; i < count; ++i)
  {
    checked.samples.push_back(i * contest.count / count);
    positions.push_back(contest.sample(checked.samples.back()));
  }
  checked.windingNumbers.resize(count);
  winding::FieldOutput output;
  output.doubleValues = checked.windingNumbers.data();
  ThreadExecutor executor;
  direct.evaluate(winding::VectorsView(positions[0].data(), count), output, executor);
  interrupt::check();
  return checked;
}

void addRows(BenchTable& table, const Contest& contest, const Triangles& triangles,
  const winding::Field& direct)
{
  const Checked checked = directSums(contest, direct);
  double ours = 0;
  for (const Contestant& contestant : contest.contestants)
  {
    vtkSmartPointer<vtkDataObject> output;
    double seconds = 0;
    const Stopwatch all;
    for (int run = 0; run < 5 && (run == 0 || all.seconds() < 2); ++run)
    {
      const auto surface =
        polyDataOf(triangles); // a new surface has neither links nor locators yet
      const double once = secondsOf([&] { output = contestant.run(surface); }, 1);
      seconds = run == 0 ? once : std::min(seconds, once);
      interrupt::check();
    }
    const bool isOurs = &contestant == &contest.contestants.front();
    ours = isOurs ? seconds : ours;
    const std::vector<double> answers = contestant.answers(output);
    if (answers.size() != contest.count)
    {
      throw winding::Refusal(contestant.name + " gave no answer");
    }
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < checked.samples.size(); ++i)
    {
      wrong += contest.isWrong(answers[checked.samples[i]], checked.windingNumbers[i]);
    }
    Json row = {{"question", contest.question}, {"samples", contest.samples},
      {"filter", contestant.name}, {"s", seconds}, {"times ours", nullptr}, {"wrong", wrong},
      {"checked", checked.samples.size()}};
    if (!isOurs)
    {
      row["times ours"] = seconds / ours;
    }
    table.add(row);
  }
}

} // namespace

std::vector<BenchTable> benchVtk(const BenchOptions& options, Messages& messages)
{
  std::vector<BenchTable> tables;
  const auto measureMesh = [&](const std::string& file, const Triangles& triangles)
  {
    winding::FieldOptions directly;
    directly.method = winding::Method::direct;
    ThreadExecutor executor;
    const auto direct = winding::Field::build(std::vector{triangles.view()}, directly, executor);
    interrupt::check();
    const winding::FieldInfo& info = direct->info();
    if (info.primitives == 0)
    {
      throw winding::Refusal("no triangle bounds anything");
    }
    const std::string title = file + ": " + std::to_string(info.primitives) + " triangles, " +
                              std::to_string(info.netBoundaryEdges) + " boundary edges, " +
                              std::to_string(threadsUsed(options.threads)) + " threads";
    BenchTable table(title,
      {"s: a new filter on a surface that is new to it",
        "wrong: answers unlike w >= 0.5 of the direct sum, of the samples checked",
        "inside: 0 or 1 for each sample; extract: the points that are inside; distance: signed "
        "ones, wrong where the sign is"});
    const std::vector<int> points = givenOr(options.points, {1000, 10'000, 100'000});
    std::vector<Contest> contests;
    contests.reserve(points.size() + 3);
    for (const int count : points)
    {
      contests.push_back(insideContest(info.bounds, static_cast<std::size_t>(count)));
    }
    const auto lastCount = static_cast<std::size_t>(points.back());
    contests.push_back(extractionContest(info.bounds, lastCount));
    contests.push_back(distanceContest(info.bounds, lastCount));
    for (const int resolution : givenOr(options.resolutions, {64}))
    {
      contests.push_back(voxelContest(info.bounds, resolution));
    }
    for (const Contest& contest : contests)
    {
      addRows(table, contest, triangles, *direct);
    }
    tables.push_back(table);
  };
  forEachMesh(options, messages, measureMesh);
  return tables;
}
