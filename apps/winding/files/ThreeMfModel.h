#pragma once

#include "files/MeshBlock.h"

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

class ZipArchive;

/// An object in its place: an item of the build, or a component of another object.
struct ThreeMfPlace
{
  std::string part; ///< the name of the model part with the object; empty for the same
  std::string id;
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
};

/// An object: a mesh, or components.
struct ThreeMfObject
{
  std::string type; ///< empty is "model"
  MeshBlock mesh;   ///< has the object's name
  std::vector<ThreeMfPlace> components;
};

/// A model part of a 3MF package.
struct ThreeMfModel
{
  std::string unit = "millimeter";
  std::map<std::string, ThreeMfObject> objects; ///< by id
  std::vector<ThreeMfPlace> items;
  std::vector<std::string> extensions; ///< that are required, by their namespaces
};

/// A slicer's notes on a part of an object: on a component, or on a range of triangles.
struct SlicerPart
{
  std::string component; ///< the id of its object; empty for triangles
  std::size_t firstTriangle = 0;
  std::size_t lastTriangle = 0;
  std::string name;
  bool isSolid = true; ///< else a modifier, a negative, or a place for supports
};

/// A slicer's notes on an object.
struct SlicerObject
{
  std::string name;
  std::vector<SlicerPart> components;
  std::vector<SlicerPart> ranges;
};

/// Returns the name of the first model part of a 3MF package.
std::string firstPartOf(const ZipArchive& archive);

/// Reads a model part, with all its meshes.
ThreeMfModel readThreeMfModel(const ZipArchive& archive, const std::string& part);

/// Reads what slicers note on the objects of the first model part, by their ids.
std::map<std::string, SlicerObject> readSlicerObjects(const ZipArchive& archive);
