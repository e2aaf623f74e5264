// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

/// All that the command line can say, with the defaults of what it leaves out.
struct Options
{
  std::string command;             ///< the name of the command, as field or surface
  std::vector<std::string> inputs; ///< the files that are read, one or more, without queries
  std::string input;               ///< names all of them in messages
  std::string queries;
  std::string columns;      ///< of the tables that are read; empty for the usual names
  std::string queryColumns; ///< of the queries
  std::string output;
  bool overwrite = false; ///< whether an output may replace a file that is read

  // The grid. Empty dimensions and bounds were not given.
  std::optional<int> resolution; ///< or the default of the command
  double voxelSize = 0;
  std::vector<int> dimensions;
  std::vector<double> bounds;
  double padding = 0.05;
  std::string like; ///< the image to lie on; empty if none is given
  bool cells = false;

  // The method. Choices have the numbers that the filters give them.
  int method = 0;
  double tolerance = 1e-3;
  int areas = 0;
  double area = 0;
  int neighbors = 20;
  double regularization = 0;
  bool estimateNormals = false;
  int normalEstimation = 0;
  std::string toward;     ///< as the filters have it; empty where it is not known
  std::string towardFile; ///< the file of positions to take for it; empty if there is none
  bool replace = false;   ///< whether normals are estimated for points that have some
  bool asPoints = false;
  bool surfaceCells = false;
  bool asIs = false; ///< whether sources are not mended
  bool orientFaces = false;
  bool ignoreOpenParts = false;
  std::string mirror; ///< as the filters have it, as are the next two
  std::string flatBase;
  std::string sheetSide;
  double weldTolerance = 0;

  // The output. Choices have the numbers that the filters give them.
  double threshold = 0.5;
  int rule = 0;
  int coverage = 0;
  int coverageSamples = 4;
  bool inside = false;
  bool insideOnly = false;
  bool insideOut = false;
  bool extract = false;
  bool fraction = false;
  bool distance = false;
  double distanceBand = 0;
  int features = 0;
  bool triangles = false;
  bool closeBorder = false;
  bool fillCavities = false;
  double gapWidth = 0;
  double offset = 0;
  double shell = 0;
  int shellSide = 0;
  int fidelity = 0;
  bool transferAttributes = false;
  bool nearestCells = false;
  bool asDouble = false;
  std::string array = "WindingNumber";

  // The labels of several solids. Choices have the numbers that the filter gives them.
  int overlap = 0;
  int shares = 0;
  bool count = false;
  std::string regionArray;
  int labelOffset = 0;

  // The operation on several solids, and what each has in place of threshold and rule: as many as
  // inputs, or none. Choices have the numbers that the filters give them.
  int operation = 0;
  std::vector<double> thresholds;
  std::vector<int> rules;

  // The treatment of a surface by check.
  bool fixOrientation = false;
  std::string faults; ///< the file of faulty edges and caps; empty if none is wanted

  std::vector<int> resolutions; ///< the grids of bench, along the longest side

  // The run.
  int threads = 0;
  double longestExpectedTime = 0;
  int pieces = 1;
  int verify = 0;
  bool json = false;
  bool quiet = false;
};
