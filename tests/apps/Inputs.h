#pragma once

#include <array>
#include <string>
#include <vector>

/// A closed mesh around the origin, outward oriented, about a sphere of radius 1.
struct Mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
};

/// An octahedron whose faces are divided in four, `levels` times, with its points on the sphere.
Mesh sphere(int levels = 3);

// The mesh as the text or bytes of a file.
std::string asOff(const Mesh& mesh);
std::string asObj(const Mesh& mesh);
std::string asPly(const Mesh& mesh);       ///< text
std::string asBinaryPly(const Mesh& mesh); ///< little endian
std::string asStl(const Mesh& mesh);       ///< text
std::string asBinaryStl(const Mesh& mesh);
std::string asVtk(const Mesh& mesh);
std::string asVtp(const Mesh& mesh);
std::string asVtu(const Mesh& mesh);

// Its points, with the normals that a sphere has there.
std::string asXyz(const Mesh& mesh);
std::string asPwn(const Mesh& mesh); ///< positions first, then normals
std::string asCsv(const Mesh& mesh); ///< with areas that add up to a sphere's

/// The file's contents for a suffix without dot, of those above; binary for "ply" and "stl".
std::string asFile(const Mesh& mesh, const std::string& suffix);
