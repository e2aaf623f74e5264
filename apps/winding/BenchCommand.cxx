#include "BenchCommands.h"
#include "Commands.h"
#include "Options.h"

void runBench(const Options& options, Messages& messages)
{
  const std::string& subject = options.subjects.front();
  const std::vector<BenchTable> tables = subject == "seed"      ? benchSeed(options, messages)
                                         : subject == "kernels" ? benchKernels(options)
                                         : subject == "clouds"  ? benchClouds(options, messages)
                                         : subject == "vtk"     ? benchVtk(options, messages)
                                         : subject == "hierarchical"
                                           ? benchHierarchical(options, messages)
                                           : benchFiles(options, messages);
  Json json = {{"threads", threadsOf(options)}, {"tables", Json::array()}};
  std::string text;
  for (const BenchTable& table : tables)
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
