// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

/// Points and triangles by their points' numbers, from 0.
struct Mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
};

/// A closed mesh around the origin, outward oriented, with points on the sphere of radius 1: an
/// octahedron whose faces are divided in four, `levels` times.
Mesh sphere(int levels = 3);

// These functions give the mesh as the text or bytes of a file.
std::string asOff(const Mesh& mesh);
std::string asObj(const Mesh& mesh);
std::string asPly(const Mesh& mesh);       ///< PLY as text
std::string asBinaryPly(const Mesh& mesh); ///< PLY as bytes, little endian
std::string asStl(const Mesh& mesh);       ///< STL as text
std::string asBinaryStl(const Mesh& mesh); ///< STL as bytes
std::string asVtk(const Mesh& mesh);
std::string asVtp(const Mesh& mesh);
std::string asVtu(const Mesh& mesh);

// These functions give the points of the mesh, with the normals that a sphere has there.
std::string asXyz(const Mesh& mesh);
std::string asPwn(const Mesh& mesh); ///< all positions, then all normals
std::string asCsv(const Mesh& mesh); ///< a table, with areas that add up to a sphere's

/// The contents of a file by its suffix, which has no dot; binary for "ply" and "stl".
std::string asFile(const Mesh& mesh, const std::string& suffix);
