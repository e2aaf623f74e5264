#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// All that the command line can say, with the defaults of what it leaves out.
struct Options
{
  std::string command; ///< field, surface, voxels, probe, check or bench
  std::string input;
  std::string queries;
  std::string output;

  // The grid. Empty: not said.
  int resolution = 64;
  double voxelSize = 0;
  std::vector<int> dimensions;
  std::vector<double> bounds;
  double padding = 0.05;
  bool cells = false;

  // The method, as the filters number their choices.
  int method = 0;
  double tolerance = 1e-3;
  int areas = 0;
  double area = 0;
  int neighbors = 20;
  double regularization = 0;
  bool estimateNormals = false;
  bool asPoints = false;

  // The output.
  double threshold = 0.5;
  int rule = 0;
  int coverage = 0;
  int coverageSamples = 4;
  bool inside = false;
  bool insideOnly = false;
  bool insideOut = false;
  bool extract = false;
  bool distance = false;
  double distanceBand = 0;
  bool closeBorder = false;
  bool asDouble = false;
  std::string array = "WindingNumber";

  // What check does with a surface.
  bool fixOrientation = false;
  std::string faults; ///< the file of faulty edges and caps; empty: none

  // What bench measures: files, or "seed", "kernels" or "hierarchical", the last with files or without;
  // "clouds" or "vtk" with files.
  std::vector<std::string> subjects;
  std::vector<int> resolutions; ///< empty: those that suit what is measured
  std::vector<double> tolerances = {1e-3};
  std::vector<int> points = {1000, 10'000, 100'000};
  std::vector<int> sources = {1000, 10'000, 100'000, 1'000'000};
  std::string data = "../shared/data";

  // The run.
  int threads = 0;
  int pieces = 1;
  int verify = 0;
  bool json = false;
  bool quiet = false;

  std::vector<int> resolutionsOr(const std::vector<int>& usual) const
  {
    return resolutions.empty() ? usual : resolutions;
  }
};

/**
 * Parses the command line. Prints help where that is asked for, and then returns nothing. Throws
 * Failure(USAGE) for command lines that make no sense, whatever the input may be.
 */
std::optional<Options> parseCommandLine(int argc, char** argv);

/// Throws Failure(USAGE) for options that make no sense, alone or together. wasGiven tells whether
/// the command line had an option.
void checkOptions(const Options& options, const std::function<bool(const char* option)>& wasGiven);

/// The part of a file name that says what is in it: lower case, with the dot; may be empty.
std::string suffixOf(const std::string& fileName);
