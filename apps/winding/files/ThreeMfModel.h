// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/MeshBlock.h"

#include <Eigen/Core>

#include <functional>
#include <map>
#include <string>
#include <vector>

class ZipArchive;

/// An object in its place: an item of the build, or a component of another object.
struct ThreeMfPlace
{
  std::string part; ///< the path of the model part with the object; empty for the same
  std::string id;
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  bool isPrinted = true; ///< whether an item is made
};

/// The purpose of an object, or of a part that a slicer notes on one.
enum class ThreeMfPurpose
{
  solid,
  support,  ///< or other things next to what is made
  modifier, ///< of a slicer: also negatives, and places where supports are wanted or not
};

/// An object: a mesh, or components.
struct ThreeMfObject
{
  ThreeMfPurpose purpose = ThreeMfPurpose::solid;
  MeshBlock mesh; ///< has the object's name
  std::vector<ThreeMfPlace> components;
};

/// A model part of a 3MF package.
struct ThreeMfModel
{
  double millimetres = 1;                       ///< of its unit
  std::string unit = "millimetres";             ///< in words
  std::map<std::string, ThreeMfObject> objects; ///< by id
  std::vector<ThreeMfPlace> items;
  std::map<std::string, std::vector<MeshColor>, std::less<>> colors; ///< of each group, by id
};

/// A slicer's notes on a part of an object: on a component, or on a range of triangles.
struct SlicerPart
{
  std::string component; ///< the id of its object; empty for triangles
  long long firstTriangle = -1;
  long long lastTriangle = -1;
  std::string name;
  ThreeMfPurpose purpose = ThreeMfPurpose::solid;
};

/// A slicer's notes on an object.
struct SlicerObject
{
  std::string name;
  std::vector<SlicerPart> components;
  std::vector<SlicerPart> ranges;
};

/// How many objects a build may place. Each takes some kilobytes.
constexpr int mostObjects = 1 << 16;

/// Throws Failure for a package that says more than there can be.
[[noreturn]] void refuseRepetitions(const ZipArchive& archive);

/// Returns the path of the first model part of a 3MF package.
std::string firstPartOf(const ZipArchive& archive);

/// Reads a model part, with all its meshes. Throws Failure where it is damaged, or needs an
/// extension other than production, material, triangle sets and slices.
ThreeMfModel readThreeMfModel(const ZipArchive& archive, const std::string& part);

/// Reads what slicers note on the objects of the first model part, by their ids. Throws Failure
/// where notes are damaged.
std::map<std::string, SlicerObject> readSlicerObjects(const ZipArchive& archive);
