// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#endif
#define TINYGLTF_IMPLEMENTATION
#include "files/GltfDocument.h"
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "files/Text.h"
#include "program/Failure.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>
#include <type_traits>
#include <utility>

namespace
{

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

/// Returns a number of either kind, which differ among versions of the library, and 0 for less.
template <class Number> std::size_t atLeastZero(Number number)
{
  return number > 0 ? static_cast<std::size_t>(number) : 0;
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

/// Whether callbacks have one for sizes of files, which newer versions of the library ask for.
template <class Callbacks, class = void> struct HasSizes : std::false_type
{
};
template <class Callbacks>
struct HasSizes<Callbacks, std::void_t<decltype(Callbacks::GetFileSizeInBytes)>> : std::true_type
{
};

/// Returns callbacks that find regular files in `folder` only. The library looks into the working
/// directory, too, and would wait for a pipe.
template <class Callbacks = tinygltf::FsCallbacks> Callbacks filesIn(std::string& folder)
{
  Callbacks callbacks = {};
  callbacks.FileExists = [](const std::string& name, void* in)
  {
    std::error_code error;
    return startsWith(name, *static_cast<std::string*>(in)) &&
           std::filesystem::is_regular_file(name, error);
  };
  callbacks.ExpandFilePath = [](const std::string& name, void*)
  {
    return name;
  };
  callbacks.ReadWholeFile = tinygltf::ReadWholeFile;
  callbacks.WriteWholeFile = tinygltf::WriteWholeFile;
  if constexpr (HasSizes<Callbacks>::value)
  {
    callbacks.GetFileSizeInBytes =
      [](std::size_t* size, std::string*, const std::string& name, void*)
    {
      std::error_code error;
      *size = std::filesystem::file_size(name, error);
      return !error;
    };
  }
  callbacks.user_data = &folder;
  return callbacks;
}

} // namespace

GltfDocument::GltfDocument(std::string fileName)
  : fileName_(std::move(fileName))
{
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                          const unsigned char*, int, void*) { return true; },
    nullptr);
  std::string error, warning, folder = std::filesystem::path(fileName_).parent_path().string();
  loader.SetFsCallbacks(filesIn(folder));
  const bool isBinary = beginningOf(fileName_, 4) == "glTF";
  const std::string text = isBinary ? "" : withPlainUris(contentsOf(fileName_));
  const bool isRead = isBinary ? loader.LoadBinaryFromFile(&model_, &error, &warning, fileName_)
                               : loader.LoadASCIIFromString(&model_, &error, &warning, text.data(),
                                   static_cast<unsigned int>(text.size()), folder);
  for (const std::string& extension : model_.extensionsRequired)
  {
    const bool isKnown =
      extension == "KHR_mesh_quantization" || extension == "EXT_mesh_gpu_instancing" ||
      extension.rfind("KHR_materials_", 0) == 0 || extension.rfind("KHR_texture_", 0) == 0 ||
      extension == "KHR_lights_punctual" || extension == "EXT_texture_webp";
    if (!isKnown)
    {
      this->refuseExtension(extension);
    }
  }
  this->checkCompression(isRead);
  if (!isRead)
  {
    const std::string line = error.substr(0, error.find('\n'));
    this->refuse("cannot be read as glTF: " + (line.empty() ? "it is damaged" : line));
  }
}

void GltfDocument::checkCompression(bool isRead) const
{
  const bool hasPositions = isRead && this->hasAllPositions();
  for (const std::string& extension : model_.extensionsUsed)
  {
    if (!hasPositions && endsWith(extension, "_compression"))
    {
      this->refuseExtension(extension);
    }
  }
}

bool GltfDocument::hasAllPositions() const
{
  const auto hasPositions = [this](const tinygltf::Primitive& primitive)
  {
    const auto position = primitive.attributes.find("POSITION");
    return position == primitive.attributes.end() ||
           this->item(model_.accessors, position->second, "accessor").bufferView >= 0;
  };
  return std::all_of(model_.meshes.begin(), model_.meshes.end(),
    [&](const tinygltf::Mesh& mesh)
    { return std::all_of(mesh.primitives.begin(), mesh.primitives.end(), hasPositions); });
}

std::size_t GltfDocument::componentsOf(int accessorNumber) const
{
  const tinygltf::Accessor& accessor = this->item(model_.accessors, accessorNumber, "accessor");
  return atLeastZero(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

std::vector<double> GltfDocument::numbers(int accessorNumber, std::size_t components) const
{
  const tinygltf::Accessor& accessor = this->item(model_.accessors, accessorNumber, "accessor");
  if (this->componentsOf(accessorNumber) != components)
  {
    this->refuse("has an accessor of another type than it must be; it is damaged");
  }
  std::vector<double> result(accessor.count * components, 0);
  if (accessor.bufferView >= 0)
  {
    this->readView(accessor.bufferView, accessor.byteOffset, accessor.componentType,
      accessor.normalized, components, result.data(), accessor.count);
  }
  if (accessor.sparse.isSparse)
  {
    const auto count = atLeastZero(accessor.sparse.count);
    std::vector<double> places(count), values(count * components);
    this->readView(accessor.sparse.indices.bufferView,
      atLeastZero(accessor.sparse.indices.byteOffset), accessor.sparse.indices.componentType, false,
      1, places.data(), count);
    this->readView(accessor.sparse.values.bufferView,
      atLeastZero(accessor.sparse.values.byteOffset), accessor.componentType, accessor.normalized,
      components, values.data(), count);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!(places[i] < static_cast<double>(accessor.count)))
      {
        this->refuse("has a sparse accessor beyond its count; it is damaged");
      }
      std::copy_n(values.data() + i * components, components,
        result.data() + static_cast<std::size_t>(places[i]) * components);
    }
  }
  return result;
}

void GltfDocument::refuse(const std::string& what) const
{
  throw Failure(EXIT_REFUSED, fileName_, what);
}

void GltfDocument::refuseExtension(const std::string& extension) const
{
  this->refuse(
    "needs the extension " + extension + "; export it without, uncompressed, or as .obj");
}

void GltfDocument::refuseNumber(int number, std::size_t count, const char* kind) const
{
  this->refuse(std::string("refers to ") + kind + " " + std::to_string(number) + " of " +
               std::to_string(count) + "; it is damaged");
}

void GltfDocument::readView(int viewNumber, std::size_t offset, int componentType,
  bool isNormalized, std::size_t components, double* to, std::size_t count) const
{
  const tinygltf::BufferView& view = this->item(model_.bufferViews, viewNumber, "buffer view");
  const tinygltf::Buffer& buffer = this->item(model_.buffers, view.buffer, "buffer");
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(componentType));
  const std::size_t bytes = atLeastZero(size);
  const std::size_t stride = view.byteStride > 0 ? view.byteStride : bytes * components;
  const std::size_t available = std::min(view.byteOffset + view.byteLength, buffer.data.size());
  const std::size_t first = view.byteOffset + offset;
  const bool fits =
    bytes > 0 && first <= available && view.byteOffset <= available &&
    (count == 0 || (available - first >= bytes * components &&
                     (available - first - bytes * components) / stride >= count - 1));
  if (!fits)
  {
    this->refuse("has an accessor beyond its buffer; it is cut off or damaged");
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
