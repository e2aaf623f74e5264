// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include <string>
#include <vector>

/**
 * A glTF 2.0 file whose parts are checked before they are looked at. Throws Failure for files that
 * are damaged, or that need an extension by which meshes are packed.
 */
class GltfDocument
{
public:
  explicit GltfDocument(std::string fileName);

  const tinygltf::Model& model() const { return model_; }

  /// Returns the item of a number, which `kind` names where there is none.
  template <class Item>
  const Item& item(const std::vector<Item>& items, int number, const char* kind) const
  {
    if (number < 0 || static_cast<std::size_t>(number) >= items.size())
    {
      this->refuseNumber(number, items.size(), kind);
    }
    return items[static_cast<std::size_t>(number)];
  }

  /// Returns how many numbers each item of an accessor has.
  std::size_t componentsOf(int accessorNumber) const;

  /// Returns the numbers of an accessor, `components` for each of its items.
  std::vector<double> numbers(int accessorNumber, std::size_t components) const;

private:
  [[noreturn]] void refuse(const std::string& what) const;
  [[noreturn]] void refuseExtension(const std::string& extension) const;
  [[noreturn]] void refuseNumber(int number, std::size_t count, const char* kind) const;
  void checkCompression(bool isRead) const; ///< of meshes that have nothing else
  bool hasAllPositions() const;
  void readView(int viewNumber, std::size_t offset, int componentType, bool isNormalized,
    std::size_t components, double* to, std::size_t count) const;

  std::string fileName_;
  tinygltf::Model model_;
};
