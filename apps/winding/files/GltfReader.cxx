#include "files/GltfReader.h"

#include "files/Text.h"
#include "program/Failure.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#endif
#include <tiny_gltf.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

vtkStandardNewMacro(GltfReader);

namespace
{

using Transform = Eigen::Matrix4d;

[[noreturn]] void refuse(const std::string& fileName, const std::string& what)
{
  throw Failure(EXIT_REFUSED, fileName, what);
}

/// A number of a component type, as it stands in memory.
double numberAt(const unsigned char* bytes, int componentType, bool isNormalized)
{
  const auto read = [bytes](auto number)
  {
    std::memcpy(&number, bytes, sizeof number);
    return number;
  };
  const auto shared = [isNormalized](double number, double most)
  {
    return isNormalized ? std::max(number / most, -1.0) : number;
  };
  switch (componentType)
  {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
    return shared(read(std::int8_t()), 127);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return shared(read(std::uint8_t()), 255);
  case TINYGLTF_COMPONENT_TYPE_SHORT:
    return shared(read(std::int16_t()), 32767);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return shared(read(std::uint16_t()), 65535);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    return read(std::uint32_t());
  case TINYGLTF_COMPONENT_TYPE_FLOAT:
    return read(float());
  default:
    return std::numeric_limits<double>::quiet_NaN();
  }
}

/// Gives all data in the text of a file the type of buffers, for the library knows a few types
/// only.
std::string withPlainUris(const std::string& text)
{
  const std::string mark = "\"data:", ending = ";base64,";
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = 0; (at = text.find(mark, done)) != std::string::npos;)
  {
    const std::size_t end = text.find(ending, at);
    const std::size_t quote = text.find('"', at + 1);
    const bool isData = end < quote;
    result += text.substr(done, at - done) + mark + (isData ? "application/octet-stream" : "");
    done = isData ? end : at + mark.size();
  }
  return result + text.substr(std::min(done, text.size()));
}

/// The parts of a file, each checked before it is looked at.
class Document
{
public:
  explicit Document(std::string fileName)
    : fileName_(std::move(fileName))
  {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                            const unsigned char*, int, void*) { return true; },
      nullptr);
    std::string error, warning;
    const bool isBinary = beginningOf(fileName_, 4) == "glTF";
    const std::string text = isBinary ? "" : withPlainUris(contentsOf(fileName_));
    const bool isRead = isBinary ? loader.LoadBinaryFromFile(&model_, &error, &warning, fileName_)
                                 : loader.LoadASCIIFromString(&model_, &error, &warning,
                                     text.data(), static_cast<unsigned int>(text.size()),
                                     std::filesystem::path(fileName_).parent_path().string());
    if (!isRead)
    {
      const std::string line = error.substr(0, error.find('\n'));
      refuse(fileName_, "cannot be read as glTF: " + (line.empty() ? "it is damaged" : line));
    }
    for (const std::string& extension : model_.extensionsRequired)
    {
      const bool isKnown =
        extension == "KHR_mesh_quantization" || extension == "EXT_mesh_gpu_instancing" ||
        extension.rfind("KHR_materials_", 0) == 0 || extension.rfind("KHR_texture_", 0) == 0 ||
        extension == "KHR_lights_punctual" || extension == "EXT_texture_webp";
      if (!isKnown)
      {
        refuse(fileName_,
          "needs the extension " + extension + "; export it without, uncompressed, or as .obj");
      }
    }
  }

  const tinygltf::Model& model() const { return model_; }

  template <class Item>
  const Item& item(const std::vector<Item>& items, int number, const char* kind) const
  {
    if (number < 0 || static_cast<std::size_t>(number) >= items.size())
    {
      refuse(fileName_, std::string("refers to ") + kind + " " + std::to_string(number) + " of " +
                          std::to_string(items.size()) + "; it is damaged");
    }
    return items[static_cast<std::size_t>(number)];
  }

  /// The numbers of an accessor, `components` for each of its items.
  std::vector<double> numbers(int accessorNumber, std::size_t components) const
  {
    const tinygltf::Accessor& accessor = this->item(model_.accessors, accessorNumber, "accessor");
    if (static_cast<std::size_t>(std::max(
          tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)), 0)) !=
        components)
    {
      refuse(fileName_, "has an accessor of another type than it must be; it is damaged");
    }
    std::vector<double> result(accessor.count * components, 0);
    if (accessor.bufferView >= 0)
    {
      this->readView(accessor.bufferView, accessor.byteOffset, accessor.componentType,
        accessor.normalized, components, result.data(), accessor.count);
    }
    if (accessor.sparse.isSparse)
    {
      const auto count = static_cast<std::size_t>(std::max(accessor.sparse.count, 0));
      std::vector<double> places(count), values(count * components);
      this->readView(accessor.sparse.indices.bufferView,
        static_cast<std::size_t>(std::max(accessor.sparse.indices.byteOffset, 0)),
        accessor.sparse.indices.componentType, false, 1, places.data(), count);
      this->readView(accessor.sparse.values.bufferView,
        static_cast<std::size_t>(std::max(accessor.sparse.values.byteOffset, 0)),
        accessor.componentType, accessor.normalized, components, values.data(), count);
      for (std::size_t i = 0; i < count; ++i)
      {
        if (!(places[i] < static_cast<double>(accessor.count)))
        {
          refuse(fileName_, "has a sparse accessor beyond its count; it is damaged");
        }
        std::copy_n(values.data() + i * components, components,
          result.data() + static_cast<std::size_t>(places[i]) * components);
      }
    }
    return result;
  }

private:
  void readView(int viewNumber, std::size_t offset, int componentType, bool isNormalized,
    std::size_t components, double* to, std::size_t count) const
  {
    const tinygltf::BufferView& view = this->item(model_.bufferViews, viewNumber, "buffer view");
    const tinygltf::Buffer& buffer = this->item(model_.buffers, view.buffer, "buffer");
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(componentType));
    const std::size_t bytes = static_cast<std::size_t>(std::max(size, 0));
    const std::size_t stride = view.byteStride > 0 ? view.byteStride : bytes * components;
    const std::size_t available = std::min(view.byteOffset + view.byteLength, buffer.data.size());
    const std::size_t first = view.byteOffset + offset;
    const bool fits =
      bytes > 0 && first <= available && view.byteOffset <= available &&
      (count == 0 || (available - first >= bytes * components &&
                       (available - first - bytes * components) / stride >= count - 1));
    if (!fits)
    {
      refuse(fileName_, "has an accessor beyond its buffer; it is cut off or damaged");
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t c = 0; c < components; ++c)
      {
        to[i * components + c] =
          numberAt(&buffer.data[first + i * stride + c * bytes], componentType, isNormalized);
      }
    }
  }

  std::string fileName_;
  tinygltf::Model model_;
};

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

/// Points and cells of one block.
struct Block
{
  std::string name;
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals; ///< of a cloud
  std::vector<std::array<vtkIdType, 3>> triangles;
  std::vector<std::array<vtkIdType, 2>> lines;
  std::vector<vtkIdType> vertices;
};

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
    std::vector<int> roots;
    if (!model_.scenes.empty())
    {
      roots = document_.item(model_.scenes, std::max(model_.defaultScene, 0), "scene").nodes;
    }
    else
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
      for (std::size_t i = 0; i < isChild.size(); ++i)
      {
        if (!isChild[i])
        {
          roots.push_back(static_cast<int>(i));
        }
      }
    }
    for (const int root : roots)
    {
      this->place(root, Transform::Identity());
    }
    for (const int node : order_)
    {
      this->addNode(
        model_.nodes[static_cast<std::size_t>(node)], places_[static_cast<std::size_t>(node)]);
    }
  }

  const std::vector<Block>& blocks() const { return blocks_; }

private:
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
    Block& block = blocks_.emplace_back();
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

  /// The transform of each vertex by the joints of a skin.
  std::vector<Transform> skinOf(
    const tinygltf::Primitive& primitive, int skinNumber, std::size_t vertices) const
  {
    const auto joints = primitive.attributes.find("JOINTS_0");
    const auto shares = primitive.attributes.find("WEIGHTS_0");
    if (skinNumber < 0 || joints == primitive.attributes.end() ||
        shares == primitive.attributes.end())
    {
      return {};
    }
    const tinygltf::Skin& skin = document_.item(model_.skins, skinNumber, "skin");
    const std::vector<double> numbers = document_.numbers(joints->second, 4);
    const std::vector<double> weights = document_.numbers(shares->second, 4);
    const std::vector<double> binds = skin.inverseBindMatrices < 0
                                        ? std::vector<double>()
                                        : document_.numbers(skin.inverseBindMatrices, 16);
    std::vector<Transform> result(vertices, Transform::Zero());
    for (std::size_t i = 0; i < 4 * vertices && i < std::min(numbers.size(), weights.size()); ++i)
    {
      if (weights[i] == 0)
      {
        continue;
      }
      const auto joint = static_cast<std::size_t>(numbers[i]);
      const int node = document_.item(skin.joints, static_cast<int>(joint), "joint");
      document_.item(model_.nodes, node, "node");
      Transform bind = Transform::Identity();
      if (16 * (joint + 1) <= binds.size())
      {
        bind = Eigen::Map<const Transform>(binds.data() + 16 * joint);
      }
      result[i / 4] += weights[i] * places_[static_cast<std::size_t>(node)] * bind;
    }
    return result;
  }

  void addPrimitive(const tinygltf::Primitive& primitive, const tinygltf::Node& node,
    const std::vector<double>& weights, const Transform& place, Block& block) const
  {
    const std::vector<double> positions = this->positionsOf(primitive, weights);
    const std::size_t vertices = positions.size() / 3;
    const std::vector<Transform> skin = this->skinOf(primitive, node.skin, vertices);
    const auto first = static_cast<vtkIdType>(block.points.size());
    for (std::size_t i = 0; i < vertices; ++i)
    {
      const Eigen::Vector4d position(
        positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], 1);
      block.points.emplace_back(((skin.empty() ? place : skin[i]) * position).head<3>());
    }
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

  void addVertices(const tinygltf::Primitive& primitive, const Transform& place,
    const std::vector<vtkIdType>& ids, std::size_t vertices, Block& block) const
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

  Document document_;
  const tinygltf::Model& model_;
  std::vector<Transform> places_; ///< by node
  std::vector<char> isVisited_;   ///< by node
  std::vector<int> order_;
  std::vector<Block> blocks_;
};

/// Makes polydata of a block. Normals are of points without faces.
vtkSmartPointer<vtkPolyData> polyDataOf(const Block& block)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& point : block.points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles, lines, vertices;
  for (const auto& triangle : block.triangles)
  {
    triangles->InsertNextCell(3, triangle.data());
  }
  for (const auto& line : block.lines)
  {
    lines->InsertNextCell(2, line.data());
  }
  for (const vtkIdType vertex : block.vertices)
  {
    vertices->InsertNextCell(1, &vertex);
  }
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->SetLines(lines);
  data->SetVerts(vertices);
  if (block.triangles.empty() && !block.normals.empty())
  {
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < block.points.size(); ++i)
    {
      const Eigen::Vector3d normal =
        i < block.normals.size() ? block.normals[i] : Eigen::Vector3d(0, 0, 0);
      normals->InsertNextTuple(normal.data());
    }
    data->GetPointData()->SetNormals(normals);
  }
  return data;
}

/// Moves blocks of lines and points alone into the first block with faces, if there is one: they
/// are cells there that bound nothing, and are counted.
void mergeLoose(std::vector<Block>& blocks)
{
  const auto hasFaces = [](const Block& block)
  {
    return !block.triangles.empty();
  };
  const auto first = std::find_if(blocks.begin(), blocks.end(), hasFaces);
  if (first == blocks.end())
  {
    return;
  }
  for (const Block& block : blocks)
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
                 [&hasFaces](const Block& block) { return !hasFaces(block); }),
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
  std::vector<Block> blocks = scene.blocks();
  mergeLoose(blocks);
  for (const Block& block : blocks)
  {
    const unsigned int number = output->GetNumberOfBlocks();
    output->SetBlock(number, polyDataOf(block));
    if (!block.name.empty())
    {
      output->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), block.name.c_str());
    }
  }
  return 1;
}
