// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Choices.h"

#include <functional>
#include <string>
#include <vector>

namespace fuzz
{

/// A property of the core, tried on one random case. It returns what is wrong, in one line, or
/// nothing.
using Check = std::function<std::string(Choices& choices)>;

struct NamedCheck
{
  const char* name;
  Check check;
};

/// The values, distances and gradients of surfaces by every method: SurfaceFieldCheck.cxx.
std::string checkSurfaceField(Choices& choices);

/// The values, distances and gradients of clouds by every method: CloudFieldCheck.cxx.
std::string checkCloudField(Choices& choices);

/// The voxels that sources touch, and the shares of voxels that are inside: CoverageCheck.cxx.
std::string checkCoverage(Choices& choices);

/// The shares of cells of any shape that are inside: FractionCheck.cxx.
std::string checkFractions(Choices& choices);

/// Orientation of faces: OrientationCheck.cxx.
std::string checkOrientation(Choices& choices);

/// Mirrors, bases and welding of surfaces: CompletionCheck.cxx.
std::string checkCompletion(Choices& choices);

/// Faults of a source, and the lines that find them: DiagnosisCheck.cxx.
std::string checkDiagnosis(Choices& choices);

/// The time of that beside the answer's.
std::string checkDiagnosisTime(Choices& choices);

/// Level roots and edges of grids: LevelCheck.cxx.
std::string checkLevel(Choices& choices);

/// Edges and roots of operations on several sources: LevelCheck.cxx.
std::string checkBoolean(Choices& choices);

/// Offsets and shells of solids: LevelCheck.cxx.
std::string checkShape(Choices& choices);

/// Places of inputs that are nearest to samples: NearestCheck.cxx.
std::string checkNearest(Choices& choices);

/// Sharp surfaces: SharpCheck.cxx.
std::string checkSharp(Choices& choices);

/// Dual meshes of random solids of a few samples are manifold: LatticeCheck.cxx.
std::string checkLattice(Choices& choices);

/// Calls of libwinding, right ones and spoiled ones: LibraryCheck.cxx.
std::string checkLibrary(Choices& choices);

/// The time of method automatic against the direct sum's: TimeCheck.cxx. The check takes far
/// longer than the others.
std::string checkTime(Choices& choices);

/// The same for 500 to 50 000 triangles that overlap each other, a second for each case.
std::string checkSoupTime(Choices& choices);

/// Returns the longest time of both checks in words, relative to the direct sum's.
std::string worstTime();

/// The growth of time with the number of triangles that crowd at a place: GrowthCheck.cxx.
std::string checkGrowth(Choices& choices);

/// All checks that time nothing, by name.
inline std::vector<NamedCheck> allChecks()
{
  return {{"surface_field", checkSurfaceField}, {"cloud_field", checkCloudField},
    {"coverage", checkCoverage}, {"fractions", checkFractions}, {"orientation", checkOrientation},
    {"completion", checkCompletion}, {"diagnosis", checkDiagnosis}, {"level", checkLevel},
    {"boolean", checkBoolean}, {"shape", checkShape}, {"nearest", checkNearest},
    {"sharp", checkSharp}, {"lattice", checkLattice}, {"library", checkLibrary}};
}

} // namespace fuzz
