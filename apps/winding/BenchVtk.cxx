#include "BenchCommands.h"
#include "BenchTools.h"
#include "Interrupt.h"
#include "Options.h"
#include "VtkContestants.h"

#include "base/Refusal.h"
#include "base/Views.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace
{

/// Samples of each contest whose answers are checked.
constexpr std::size_t mostChecked = 2000;

/// The direct sums at samples of a contest, evenly chosen.
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
    for (int run = 0; run < 5 && (run == 0 || all.total() < 2); ++run)
    {
      const auto surface = polyDataOf(triangles); // nothing is built beside it yet
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

std::vector<BenchTable> benchVtk(const Options& options, Messages& messages)
{
  std::vector<BenchTable> tables;
  forEachMesh(options, 1, messages,
    [&](const std::string& file, const Triangles& triangles)
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
      BenchTable table(file + ": " + std::to_string(info.primitives) + " triangles, " +
                         std::to_string(info.netBoundaryEdges) + " boundary edges, " +
                         std::to_string(threadsOf(options)) + " threads",
        {"s: a new filter on a surface that is new to it",
          "wrong: answers unlike w >= 0.5 of the direct sum, at so many samples checked",
          "inside: 0 or 1 for each sample; extract: the points that are inside; distance: signed "
          "ones, wrong where the sign is"});
      std::vector<Contest> contests;
      for (const int points : options.points)
      {
        contests.push_back(insideContest(info.bounds, static_cast<std::size_t>(points)));
      }
      const auto mostPoints = static_cast<std::size_t>(options.points.back());
      contests.push_back(extractionContest(info.bounds, mostPoints));
      contests.push_back(distanceContest(info.bounds, mostPoints));
      for (const int resolution : options.resolutionsOr({64}))
      {
        contests.push_back(voxelContest(info.bounds, resolution));
      }
      for (const Contest& contest : contests)
      {
        addRows(table, contest, triangles, *direct);
      }
      tables.push_back(table);
    });
  return tables;
}
