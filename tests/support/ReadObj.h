// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Shapes.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace shapes
{

/// The vertices, rounded to float as VTK's readers do, and triangles of an OBJ file; an empty mesh
/// if there is no file.
inline Mesh readObj(const std::string& path)
{
  Mesh mesh;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string kind, a, b, c;
    words >> kind >> a >> b >> c;
    if (kind == "v")
    {
      mesh.points.emplace_back(std::strtof(a.c_str(), nullptr), std::strtof(b.c_str(), nullptr),
        std::strtof(c.c_str(), nullptr));
    }
    else if (kind == "f")
    {
      // atoi stops at the slash of "vertex/texture/normal".
      mesh.triangles.push_back(
        {std::atoi(a.c_str()) - 1, std::atoi(b.c_str()) - 1, std::atoi(c.c_str()) - 1});
    }
  }
  return mesh;
}

} // namespace shapes
