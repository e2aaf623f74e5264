// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/GltfReader.h"

#include "files/GltfDocument.h"
#include "files/MeshBlock.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(GltfReader);

namespace
{

using Transform = Eigen::Matrix4d;

Transform transformOf(const std::vector<double>& translation, const std::vector<double>& rotation,
  const std::vector<double>& scale)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  if (translation.size() == 3)
  {
    result.translate(Eigen::Vector3d(translation.data()));
  }
  if (rotation.size() == 4)
  {
    result.rotate(
      Eigen::Quaterniond(rotation[3], rotation[0], rotation[1], rotation[2]).normalized());
  }
  if (scale.size() == 3)
  {
    result.scale(Eigen::Vector3d(scale.data()));
  }
  return result.matrix();
}

/// Where a node stands in its parent.
Transform transformOf(const tinygltf::Node& node)
{
  return node.matrix.size() == 16 ? Transform(Eigen::Map<const Transform>(node.matrix.data()))
                                  : transformOf(node.translation, node.rotation, node.scale);
}

/// Makes blocks of the nodes of a scene.
class Scene
{
public:
  explicit Scene(const std::string& fileName)
    : document_(fileName)
    , model_(document_.model())
    , places_(model_.nodes.size(), Transform::Identity())
    , isVisited_(model_.nodes.size(), 0)
  {
    if (!model_.scenes.empty())
    {
      for (const int root :
        document_.item(model_.scenes, std::max(model_.defaultScene, 0), "scene").nodes)
      {
        this->place(root, Transform::Identity());
      }
    }
    const std::size_t shown = model_.scenes.empty() ? model_.nodes.size() : order_.size();
    for (const int root : this->topNodes()) // joints need not be in the scene
    {
      this->place(root, Transform::Identity());
    }
    order_.resize(std::min(shown, order_.size()));
    for (const int node : order_)
    {
      this->addNode(
        model_.nodes[static_cast<std::size_t>(node)], places_[static_cast<std::size_t>(node)]);
    }
  }

  const std::vector<MeshBlock>& blocks() const { return blocks_; }

private:
  /// Returns the nodes that are below no other.
  std::vector<int> topNodes() const
  {
    std::vector<char> isChild(model_.nodes.size(), 0);
    for (const tinygltf::Node& node : model_.nodes)
    {
      for (const int child : node.children)
      {
        document_.item(model_.nodes, child, "node");
        isChild[static_cast<std::size_t>(child)] = 1;
      }
    }
    std::vector<int> tops;
    for (std::size_t i = 0; i < isChild.size(); ++i)
    {
      if (!isChild[i])
      {
        tops.push_back(static_cast<int>(i));
      }
    }
    return tops;
  }

  /// Finds where a node and those below it stand. A node has one parent at most.
  void place(int root, const Transform& parent)
  {
    std::vector<std::pair<int, Transform>> left = {{root, parent}};
    while (!left.empty())
    {
      const auto [number, above] = left.back();
      left.pop_back();
      const tinygltf::Node& node = document_.item(model_.nodes, number, "node");
      const auto index = static_cast<std::size_t>(number);
      if (isVisited_[index])
      {
        continue;
      }
      isVisited_[index] = 1;
      places_[index] = above * transformOf(node);
      order_.push_back(number);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      {
        left.emplace_back(*child, places_[index]);
      }
    }
  }

  void addNode(const tinygltf::Node& node, const Transform& place)
  {
    if (node.mesh < 0)
    {
      return;
    }
    const tinygltf::Mesh& mesh = document_.item(model_.meshes, node.mesh, "mesh");
    MeshBlock& block = blocks_.emplace_back();
    block.name = !node.name.empty() ? node.name : mesh.name;
    const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
    for (const tinygltf::Primitive& primitive : mesh.primitives)
    {
      for (const Transform& instance : this->instancesOf(node))
      {
        this->addPrimitive(primitive, node, weights, place * instance, block);
      }
    }
  }

  /// The places of the instances of a node within it (EXT_mesh_gpu_instancing).
  std::vector<Transform> instancesOf(const tinygltf::Node& node) const
  {
    const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == node.extensions.end() || !extension->second.Has("attributes"))
    {
      return {Transform::Identity()};
    }
    const tinygltf::Value& attributes = extension->second.Get("attributes");
    std::size_t count = 0;
    const auto read = [&](const char* name, std::size_t components)
    {
      std::vector<double> numbers;
      if (attributes.Has(name))
      {
        numbers = document_.numbers(attributes.Get(name).GetNumberAsInt(), components);
        count = std::max(count, numbers.size() / components);
      }
      return numbers;
    };
    const std::vector<double> moves = read("TRANSLATION", 3), turns = read("ROTATION", 4),
                              scales = read("SCALE", 3);
    const auto partOf = [](const std::vector<double>& numbers, std::size_t i, std::size_t n)
    {
      return (i + 1) * n <= numbers.size()
               ? std::vector<double>(numbers.begin() + static_cast<std::ptrdiff_t>(i * n),
                   numbers.begin() + static_cast<std::ptrdiff_t>((i + 1) * n))
               : std::vector<double>();
    };
    std::vector<Transform> instances;
    for (std::size_t i = 0; i < count; ++i)
    {
      instances.push_back(
        transformOf(partOf(moves, i, 3), partOf(turns, i, 4), partOf(scales, i, 3)));
    }
    return instances;
  }

  /// The positions of a primitive, moved by its morph targets.
  std::vector<double> positionsOf(
    const tinygltf::Primitive& primitive, const std::vector<double>& weights) const
  {
    const auto attribute = primitive.attributes.find("POSITION");
    if (attribute == primitive.attributes.end())
    {
      return {};
    }
    std::vector<double> positions = document_.numbers(attribute->second, 3);
    for (std::size_t i = 0; i < std::min(weights.size(), primitive.targets.size()); ++i)
    {
      const auto target = primitive.targets[i].find("POSITION");
      if (target == primitive.targets[i].end() || weights[i] == 0)
      {
        continue;
      }
      const std::vector<double> moves = document_.numbers(target->second, 3);
      for (std::size_t n = 0; n < std::min(moves.size(), positions.size()); ++n)
      {
        positions[n] += weights[i] * moves[n];
      }
    }
    return positions;
  }

  /// Returns the transform of each vertex by the joints of a skin, whose weights may have any sum;
  /// `place` where they have none. Nothing for a primitive without joints.
  std::vector<Transform> skinOf(const tinygltf::Primitive& primitive, int skinNumber,
    std::size_t vertices, const Transform& place) const
  {
    std::vector<Transform> result;
    std::vector<double> sums(vertices, 0);
    for (int set = 0; skinNumber >= 0; ++set) // of four joints each
    {
      const auto joints = primitive.attributes.find("JOINTS_" + std::to_string(set));
      const auto shares = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
      if (joints == primitive.attributes.end() || shares == primitive.attributes.end())
      {
        break;
      }
      result.resize(vertices, Transform::Zero());
      this->addJoints(document_.item(model_.skins, skinNumber, "skin"),
        document_.numbers(joints->second, 4), document_.numbers(shares->second, 4), result, sums);
    }
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      result[i] = sums[i] > 0 ? Transform(result[i] / sums[i]) : place;
    }
    return result;
  }

  /// Adds the transforms of four joints of each vertex by their weights, and these to their sums.
  void addJoints(const tinygltf::Skin& skin, const std::vector<double>& joints,
    const std::vector<double>& weights, std::vector<Transform>& result,
    std::vector<double>& sums) const
  {
    const std::vector<double> binds = skin.inverseBindMatrices < 0
                                        ? std::vector<double>()
                                        : document_.numbers(skin.inverseBindMatrices, 16);
    for (std::size_t i = 0; i < 4 * result.size() && i < std::min(joints.size(), weights.size());
         ++i)
    {
      if (weights[i] == 0)
      {
        continue;
      }
      const auto joint = static_cast<std::size_t>(joints[i]);
      const int node = document_.item(skin.joints, static_cast<int>(joint), "joint");
      document_.item(model_.nodes, node, "node");
      Transform bind = Transform::Identity();
      if (16 * (joint + 1) <= binds.size())
      {
        bind = Eigen::Map<const Transform>(binds.data() + 16 * joint);
      }
      result[i / 4] += weights[i] * places_[static_cast<std::size_t>(node)] * bind;
      sums[i / 4] += weights[i];
    }
  }

  void addPrimitive(const tinygltf::Primitive& primitive, const tinygltf::Node& node,
    const std::vector<double>& weights, const Transform& place, MeshBlock& block) const
  {
    const std::vector<double> positions = this->positionsOf(primitive, weights);
    const std::size_t vertices = positions.size() / 3;
    const std::vector<Transform> skin = this->skinOf(primitive, node.skin, vertices, place);
    const auto first = static_cast<vtkIdType>(block.points.size());
    for (std::size_t i = 0; i < vertices; ++i)
    {
      const Eigen::Vector4d position(
        positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], 1);
      block.points.emplace_back(((skin.empty() ? place : skin[i]) * position).head<3>());
    }
    this->addColors(primitive, vertices, block);
    const Transform& whole = skin.empty() ? place : skin.front();
    const bool isMirrored = whole.topLeftCorner<3, 3>().determinant() < 0;
    std::vector<vtkIdType> ids;
    if (primitive.indices >= 0)
    {
      for (const double number : document_.numbers(primitive.indices, 1))
      {
        ids.push_back(first + static_cast<vtkIdType>(number)); // too large ones are found later
      }
    }
    else
    {
      for (std::size_t i = 0; i < vertices; ++i)
      {
        ids.push_back(first + static_cast<vtkIdType>(i));
      }
    }
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode == TINYGLTF_MODE_POINTS)
    {
      this->addVertices(primitive, place, ids, vertices, block);
    }
    else if (mode < TINYGLTF_MODE_TRIANGLES)
    {
      const std::size_t step = mode == TINYGLTF_MODE_LINE ? 2 : 1;
      for (std::size_t i = 0; i + 1 < ids.size(); i += step)
      {
        block.lines.push_back({ids[i], ids[i + 1]});
      }
    }
    else
    {
      addTriangles(ids, mode, isMirrored, block.triangles);
    }
  }

  /// Adds the colors of the last vertices of a block, as they are in the file: of no gamma.
  void addColors(const tinygltf::Primitive& primitive, std::size_t vertices, MeshBlock& block) const
  {
    const auto attribute = primitive.attributes.find("COLOR_0");
    if (attribute == primitive.attributes.end())
    {
      return;
    }
    const std::size_t components = document_.componentsOf(attribute->second) == 3 ? 3 : 4;
    const std::vector<double> numbers = document_.numbers(attribute->second, components);
    block.colors.resize(block.points.size(), white);
    MeshColor* const colors = block.colors.data() + block.colors.size() - vertices;
    for (std::size_t i = 0; i < std::min(components * vertices, numbers.size()); ++i)
    {
      constexpr double most = 255;
      const double number = std::round(most * numbers[i]);
      colors[i / components][i % components] =
        static_cast<unsigned char>(number > 0 ? std::min(number, most) : 0); // not NaN
    }
  }

  void addVertices(const tinygltf::Primitive& primitive, const Transform& place,
    const std::vector<vtkIdType>& ids, std::size_t vertices, MeshBlock& block) const
  {
    block.vertices.insert(block.vertices.end(), ids.begin(), ids.end());
    const auto normals = primitive.attributes.find("NORMAL");
    if (normals == primitive.attributes.end())
    {
      return;
    }
    const std::vector<double> numbers = document_.numbers(normals->second, 3);
    const Eigen::Matrix3d turn = place.topLeftCorner<3, 3>().inverse().transpose();
    block.normals.resize(block.points.size() - vertices, Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < vertices && 3 * i + 2 < numbers.size(); ++i)
    {
      block.normals.emplace_back(turn * Eigen::Vector3d(numbers.data() + 3 * i));
    }
  }

  static void addTriangles(const std::vector<vtkIdType>& ids, int mode, bool isMirrored,
    std::vector<std::array<vtkIdType, 3>>& triangles)
  {
    const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    for (std::size_t i = 0; i + 2 < ids.size(); i += step)
    {
      const std::size_t start = mode == TINYGLTF_MODE_TRIANGLE_FAN ? 0 : i;
      std::array<vtkIdType, 3> triangle = {ids[start], ids[i + 1], ids[i + 2]};
      const bool isOdd = mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1;
      if (isOdd != isMirrored)
      {
        std::swap(triangle[1], triangle[2]);
      }
      triangles.push_back(triangle);
    }
  }

  GltfDocument document_;
  const tinygltf::Model& model_;
  std::vector<Transform> places_; ///< by node
  std::vector<char> isVisited_;   ///< by node
  std::vector<int> order_;
  std::vector<MeshBlock> blocks_;
};

/// Moves blocks of lines and points alone into the first block with faces, if there is one: they
/// are cells there that bound nothing, and are counted.
void mergeLoose(std::vector<MeshBlock>& blocks)
{
  const auto hasFaces = [](const MeshBlock& block)
  {
    return !block.triangles.empty();
  };
  const auto first = std::find_if(blocks.begin(), blocks.end(), hasFaces);
  if (first == blocks.end())
  {
    return;
  }
  for (const MeshBlock& block : blocks)
  {
    const auto start = static_cast<vtkIdType>(first->points.size());
    if (hasFaces(block))
    {
      continue;
    }
    first->points.insert(first->points.end(), block.points.begin(), block.points.end());
    for (const auto& [from, to] : block.lines)
    {
      first->lines.push_back({start + from, start + to});
    }
    for (const vtkIdType vertex : block.vertices)
    {
      first->vertices.push_back(start + vertex);
    }
  }
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [&hasFaces](const MeshBlock& block) { return !hasFaces(block); }),
    blocks.end());
}

} // namespace

GltfReader::GltfReader()
{
  this->SetNumberOfInputPorts(0);
}

int GltfReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkMultiBlockDataSet* const output = vtkMultiBlockDataSet::GetData(outputs, 0);
  const Scene scene(fileName_);
  std::vector<MeshBlock> blocks = scene.blocks();
  mergeLoose(blocks);
  const bool isAnyClear = std::any_of(
    blocks.begin(), blocks.end(), [](const MeshBlock& block) { return areAnyClear(block.colors); });
  for (const MeshBlock& block : blocks)
  {
    appendBlock(block, isAnyClear, output);
  }
  return 1;
}
