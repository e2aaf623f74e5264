// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace winding
{

/**
 * The numbers by which messages name what a user can set or turn to. The core has no other names
 * for them: each front end has its own, in one list (filters/Options.def).
 */
enum class Parameter
{
  // the method
  method,
  tolerance,
  regularization,
  numberOfThreads,
  longestExpectedTime,

  // the source
  sourceAsPoints,
  surfaceCells,
  mendSource,
  orientFaces,
  ignoreOpenParts,
  mirror,
  flatBase,
  sheetSide,
  weldTolerance,
  sourceDistribution,
  normalsArray,
  estimateNormals,
  normalEstimation,
  toward,
  pointAreaMethod,
  pointArea,
  areaArray,
  numberOfNeighbors,

  // the grid
  resolution,
  voxelSize,
  samplingDimensions,
  useInputBounds,
  boundsOverAllTimes,
  samplingBounds,
  padding,
  outputAssociation,

  // what is inside
  windingThreshold,
  insideRule,
  insideOut,
  coverage,
  coverageSamples,
  unionOverAllTimes,

  // the arrays of the result
  generateWindingNumber,
  generateInside,
  generateSignedDistance,
  generateFraction,
  distanceBand,
  resultArrayName,
  insideArrayName,
  outputScalarType,
  verifySamples,

  // surfaces
  features,
  generateTriangles,
  closeBorder,
  fillCavities,
  gapWidth,
  offset,
  shell,
  shellSide,
  generateNormals,
  outputPointsPrecision,
  generateDistanceToInput,
  transferAttributes,
  generateNearestCells,
  generateImage,
  fidelitySamples,

  // booleans
  booleanOperation,

  // labels
  overlapRule,
  regionArray,
  labelOffset,
  generateSolidCount,
  coverageArrays,
  byLabel,

  // probes
  probeAssociation,
  extractInside,

  // reports
  fixOrientation,
  faultThickness,

  // tables of points
  columns,
  readNormalsAndAreas,
  readAllColumns,
  keepRows,

  // inputs, other filters and other ways of working
  source,
  others,
  like,
  probe,
  voxelArray,
  pieces,
  surfaceReport,
  image,
  contour,
  tube,
  orientedNormals,
  replacedNormals
};

} // namespace winding
