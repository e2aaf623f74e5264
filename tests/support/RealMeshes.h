// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace shapes
{

/// Returns the path of a file in the folder of real meshes.
inline std::string realMesh(const std::string& name)
{
  return std::string(WINDING_SHARED_DATA "/") + name;
}

/// Returns the items whose file is in the folder of real meshes, which has few files in a fresh
/// clone. `nameOf` gives the name of an item's file.
template <class Item, class NameOf>
std::vector<Item> present(std::initializer_list<Item> items, const NameOf& nameOf)
{
  std::vector<Item> found;
  for (const Item& item : items)
  {
    if (std::filesystem::exists(realMesh(nameOf(item))))
    {
      found.push_back(item);
    }
  }
  return found;
}

/// Returns the names whose file is in the folder of real meshes.
inline std::vector<const char*> present(std::initializer_list<const char*> names)
{
  return present(names, [](const char* name) { return name; });
}

/// Returns the name of a file as names of tests may have it.
inline std::string testNameOf(std::string file)
{
  return file.replace(file.rfind('.'), 1, "_");
}

} // namespace shapes
