// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <stdexcept>

namespace
{

class Sphere
{
public:
  explicit Sphere(int levels)
  {
    mesh_.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh_.triangles = {
      {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level)
    {
      this->divide();
    }
  }

  const Mesh& mesh() const { return mesh_; }

private:
  void divide()
  {
    std::vector<std::array<int, 3>> smaller;
    for (const auto& [a, b, c] : mesh_.triangles)
    {
      const int ab = this->middle(a, b), bc = this->middle(b, c), ca = this->middle(c, a);
      smaller.insert(smaller.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh_.triangles = smaller;
  }

  int middle(int a, int b)
  {
    const auto edge = std::minmax(a, b);
    const auto [place, isNew] = middles_.try_emplace(edge, static_cast<int>(mesh_.points.size()));
    if (isNew)
    {
      std::array<double, 3> point;
      double length = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        point[axis] = mesh_.points[static_cast<std::size_t>(a)][axis] +
                      mesh_.points[static_cast<std::size_t>(b)][axis];
        length = std::hypot(length, point[axis]);
      }
      for (double& coordinate : point)
      {
        coordinate /= length;
      }
      mesh_.points.push_back(point);
    }
    return place->second;
  }

  Mesh mesh_;
  std::map<std::pair<int, int>, int> middles_;
};

std::string rows(const Mesh& mesh, const std::string& before)
{
  std::ostringstream text;
  text.precision(17);
  for (const auto& [x, y, z] : mesh.points)
  {
    text << before << x << " " << y << " " << z << "\n";
  }
  return text.str();
}

std::string faces(const Mesh& mesh, const std::string& before, int firstId = 0)
{
  std::ostringstream text;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    text << before << a + firstId << " " << b + firstId << " " << c + firstId << "\n";
  }
  return text.str();
}

std::string numbers(const Mesh& mesh)
{
  return std::to_string(mesh.points.size()) + " " + std::to_string(mesh.triangles.size());
}

std::string plyHeader(const Mesh& mesh, const std::string& format)
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class Number> void append(std::string& bytes, Number value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void appendPoint(std::string& bytes, const std::array<double, 3>& point)
{
  for (const double coordinate : point)
  {
    append(bytes, static_cast<float>(coordinate));
  }
}

std::string xmlArray(const std::string& type, const std::string& name, const std::string& values)
{
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" +
         (name == "Points" ? " NumberOfComponents=\"3\"" : "") + " format=\"ascii\">\n" + values +
         "</DataArray>\n";
}

std::string xmlCells(const Mesh& mesh)
{
  std::string offsets;
  for (std::size_t i = 1; i <= mesh.triangles.size(); ++i)
  {
    offsets += std::to_string(3 * i) + "\n";
  }
  return xmlArray("Int64", "connectivity", faces(mesh, "")) + xmlArray("Int64", "offsets", offsets);
}

std::string xmlFile(const std::string& type, const std::string& piece, const std::string& contents)
{
  return "<VTKFile type=\"" + type + "\" version=\"1.0\" byte_order=\"LittleEndian\">\n<" + type +
         ">\n<Piece " + piece + ">\n" + contents + "</Piece>\n</" + type + ">\n</VTKFile>\n";
}

} // namespace

Mesh sphere(int levels)
{
  return Sphere(levels).mesh();
}

std::string asOff(const Mesh& mesh)
{
  return "OFF\n" + numbers(mesh) + " 0\n" + rows(mesh, "") + faces(mesh, "3 ");
}

std::string asObj(const Mesh& mesh)
{
  return rows(mesh, "v ") + faces(mesh, "f ", 1);
}

std::string asPly(const Mesh& mesh)
{
  return plyHeader(mesh, "ascii") + rows(mesh, "") + faces(mesh, "3 ");
}

std::string asBinaryPly(const Mesh& mesh)
{
  std::string bytes = plyHeader(mesh, "binary_little_endian");
  for (const auto& point : mesh.points)
  {
    appendPoint(bytes, point);
  }
  for (const auto& triangle : mesh.triangles)
  {
    append(bytes, std::uint8_t(3));
    for (const int id : triangle)
    {
      append(bytes, std::int32_t(id));
    }
  }
  return bytes;
}

std::string asStl(const Mesh& mesh)
{
  std::ostringstream text;
  text << "solid sphere\n";
  for (const auto& triangle : mesh.triangles)
  {
    text << " facet normal 0 0 0\n  outer loop\n";
    for (const int id : triangle)
    {
      const auto& [x, y, z] = mesh.points[static_cast<std::size_t>(id)];
      text << "   vertex " << x << " " << y << " " << z << "\n";
    }
    text << "  endloop\n endfacet\n";
  }
  text << "endsolid sphere\n";
  return text.str();
}

std::string asBinaryStl(const Mesh& mesh)
{
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles)
  {
    appendPoint(bytes, {0, 0, 0});
    for (const int id : triangle)
    {
      appendPoint(bytes, mesh.points[static_cast<std::size_t>(id)]);
    }
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

std::string asVtk(const Mesh& mesh)
{
  return "# vtk DataFile Version 3.0\nsphere\nASCII\nDATASET POLYDATA\nPOINTS " +
         std::to_string(mesh.points.size()) + " double\n" + rows(mesh, "") + "POLYGONS " +
         std::to_string(mesh.triangles.size()) + " " + std::to_string(4 * mesh.triangles.size()) +
         "\n" + faces(mesh, "3 ");
}

std::string asVtp(const Mesh& mesh)
{
  return xmlFile("PolyData",
    "NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\" NumberOfPolys=\"" +
      std::to_string(mesh.triangles.size()) + "\"",
    "<Points>\n" + xmlArray("Float64", "Points", rows(mesh, "")) + "</Points>\n<Polys>\n" +
      xmlCells(mesh) + "</Polys>\n");
}

std::string asVtu(const Mesh& mesh)
{
  std::string types;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    types += "5\n";
  }
  return xmlFile("UnstructuredGrid",
    "NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
      std::to_string(mesh.triangles.size()) + "\"",
    "<Points>\n" + xmlArray("Float64", "Points", rows(mesh, "")) + "</Points>\n<Cells>\n" +
      xmlCells(mesh) + xmlArray("UInt8", "types", types) + "</Cells>\n");
}

std::string asXyz(const Mesh& mesh)
{
  std::ostringstream text;
  text.precision(17);
  for (const auto& [x, y, z] : mesh.points)
  {
    text << x << " " << y << " " << z << " " << x << " " << y << " " << z << "\n";
  }
  return text.str();
}

std::string asPwn(const Mesh& mesh)
{
  return std::to_string(mesh.points.size()) + "\n" + rows(mesh, "") + rows(mesh, "");
}

std::string asCsv(const Mesh& mesh)
{
  const double area = 4 * 3.14159265358979323846 / static_cast<double>(mesh.points.size());
  std::ostringstream text;
  text.precision(17);
  text << "x,y,z,nx,ny,nz,area\n";
  for (const auto& [x, y, z] : mesh.points)
  {
    text << x << "," << y << "," << z << "," << x << "," << y << "," << z << "," << area << "\n";
  }
  return text.str();
}

std::string asFile(const Mesh& mesh, const std::string& suffix)
{
  const std::map<std::string, std::string (*)(const Mesh&)> writers = {{"off", asOff},
    {"obj", asObj}, {"ply", asBinaryPly}, {"stl", asBinaryStl}, {"vtk", asVtk}, {"vtp", asVtp},
    {"vtu", asVtu}, {"xyz", asXyz}, {"pwn", asPwn}, {"csv", asCsv}};
  return writers.at(suffix)(mesh);
}
