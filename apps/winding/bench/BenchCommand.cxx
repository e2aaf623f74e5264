#include "bench/BenchCommand.h"

#include "bench/BenchChecks.h"
#include "bench/BenchSubjects.h"
#include "options/Options.h"
#include "program/Print.h"
#include "program/Threads.h"

#include <map>

void runBench(const Options& options, Messages& messages)
{
  checkBenchOptions(options.bench);
  const std::map<std::string, std::vector<BenchTable> (*)(const Options&, Messages&)> subjects = {
    {"seed", benchSeed}, {"kernels", benchKernels}, {"clouds", benchClouds}, {"vtk", benchVtk},
    {"expected", benchExpected}, {"hierarchical", benchHierarchical},
    {"orientation", benchOrientation}};
  const auto subject = subjects.find(options.bench.subjects.front());
  const auto measure = subject == subjects.end() ? benchFiles : subject->second;

  Json json = {{"threads", threadsUsed(options.threads)}, {"tables", Json::array()}};
  std::string text;
  for (const BenchTable& table : measure(options, messages))
  {
    json["tables"].push_back(table.json());
    text += (text.empty() ? "" : "\n") + table.text();
  }
  if (options.json)
  {
    print(json);
    return;
  }
  text.pop_back(); // print() ends the line
  print(text);
}
