// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"
#include "Handles.h"
#include "files/InputFile.h"
#include "files/MeshFormats.h"
#include "files/PointsFile.h"
#include "files/TableFile.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace winding::c;

namespace
{

template <class Number, class To>
void copy(const winding::PlainArray<Number>& from, winding::UninitializedVector<To>& to)
{
  to.assign(from.begin(), from.end());
}

/// Keeps the texts of columns in a mesh. The columns are made first.
class ColumnTexts final : public winding::TextColumns
{
public:
  void add(std::size_t column, std::size_t rows) override { texts_[column].resize(rows); }
  void set(std::size_t column, std::size_t row, const std::string& text) override
  {
    texts_.find(column)->second[row] = text;
  }
  std::vector<std::string> take(std::size_t column) { return std::move(texts_[column]); }

private:
  std::map<std::size_t, std::vector<std::string>> texts_;
};

/// Gives a mesh all of a file but its polygons.
void takePoints(const winding::MeshArrays& arrays, winding_mesh& mesh)
{
  copy(arrays.points.floats, mesh.floatPoints);
  copy(arrays.points.doubles, mesh.doublePoints);
  copy(arrays.normals.floats, mesh.pointNormals);
  copy(arrays.normals.doubles, mesh.doublePointNormals);
  copy(arrays.areas, mesh.pointAreas);
  copy(arrays.vertices.offsets, mesh.vertexOffsets);
  copy(arrays.vertices.connectivity, mesh.vertexCorners);
  copy(arrays.lines.offsets, mesh.lineOffsets);
  copy(arrays.lines.connectivity, mesh.lineCorners);
  copy(arrays.colors, mesh.colors);
  mesh.colorComponents = arrays.colorComponents;
  copy(arrays.textureCoordinates, mesh.textureCoordinates);
}

std::vector<const char*> pointersTo(const std::vector<std::string>& texts)
{
  std::vector<const char*> pointers;
  for (const std::string& text : texts)
  {
    pointers.push_back(text.c_str());
  }
  return pointers;
}

/// Gives a mesh the columns of a table.
void takeColumns(const winding::PointTable& table, ColumnTexts& texts, winding_mesh& mesh)
{
  for (std::size_t i = 0; i < table.columns.size(); ++i)
  {
    const winding::TableColumn& from = table.columns[i];
    winding_mesh::Column& to = mesh.columns.emplace_back();
    to.name = from.name;
    to.numbers.assign(from.numbers.begin(), from.numbers.end());
    to.texts = texts.take(i);
  }
  for (winding_mesh::Column& column : mesh.columns)
  {
    column.pointers = pointersTo(column.texts);
  }
}

/// Gives a mesh the polygons of a file, and their regions.
void takePolygons(winding::MeshArrays& arrays, winding_mesh& mesh)
{
  copy(arrays.polygons.offsets, mesh.offsets);
  copy(arrays.polygons.connectivity, mesh.corners);
  for (winding::NamedRegions& from : arrays.regions)
  {
    winding_mesh::Regions& to = mesh.regions.emplace_back();
    to.kind = from.kind;
    to.names = std::move(from.names);
    copy(from.ofPolygon, to.ofPolygon);
  }
  for (winding_mesh::Regions& regions : mesh.regions)
  {
    regions.pointers = pointersTo(regions.names);
  }
}

/// Gives a mesh what was read, and warns of what was not.
void takeMesh(winding::MeshArrays arrays, Call& call, winding_mesh& made)
{
  call.warn(arrays.notes);
  takePoints(arrays, made);
  takePolygons(arrays, made);
  for (const winding::OtherNumbers& other : arrays.others)
  {
    winding_mesh::Column& column = made.columns.emplace_back();
    column.name = other.name;
    column.numbers.assign(other.numbers.begin(), other.numbers.end());
  }
}

/// Reads a file of any format.
void readInto(winding_mesh& made, const winding::InputFile& file,
  const winding::ColumnWishes& wishes, bool normalsAndAreas, Call& call)
{
  const winding::MeshFormat& format = winding::formatOf(file);
  if (format.read)
  {
    takeMesh(format.read(file, wishes, call.executor), call, made);
    return;
  }
  ColumnTexts texts;
  winding::TableOptions options;
  options.separator = format.separator;
  options.columns = wishes.chosen;
  options.normalsAndAreas = normalsAndAreas;
  options.texts = wishes.others ? &texts : nullptr;
  winding::PointTable table = winding::readPointTable(file, options, call.executor);
  takeMesh(std::move(table.points), call, made);
  takeColumns(table, texts, made);
}

/// Makes a mesh of a file by read(file, call, mesh).
template <class Read>
winding_status readFile(const char* path, const winding_run* run, winding_mesh** mesh,
  winding_refusal* refusal, const Read& read)
{
  return guarded(run, refusal,
    [&]
    {
      required(mesh, "mesh") = nullptr;
      if (required(path, "path") == 0)
      {
        throw Misuse("path is empty");
      }
      Call call(run);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          const winding::InputFile file(path);
          read(file, call, made);
        });
    });
}

/// Returns an item by its number. Throws Misuse, naming the `count`, where there is none.
template <class Item>
const Item& itemAt(const std::vector<Item>& items, int64_t index, const char* count)
{
  if (index < 0 || index >= static_cast<int64_t>(items.size()))
  {
    throw Misuse(std::string("index is not less than ") + count);
  }
  return items[static_cast<std::size_t>(index)];
}

} // namespace

winding_status winding_read(
  const char* path, const winding_run* run, winding_mesh** mesh, winding_refusal* refusal)
{
  return readFile(path, run, mesh, refusal,
    [](const winding::InputFile& file, Call& call, winding_mesh& made)
    { readInto(made, file, {}, true, call); });
}

winding_status winding_read_columns(const char* path, const char* columns, const winding_run* run,
  winding_mesh** mesh, winding_refusal* refusal)
{
  return readFile(path, run, mesh, refusal,
    [columns](const winding::InputFile& file, Call& call, winding_mesh& made)
    {
      const winding::ColumnChoice choice(&required(columns, "columns"));
      if (!choice.empty() && !winding::formatOf(file).hasColumns)
      {
        file.refuse("has no columns; choose none");
      }
      readInto(made, file, {choice, true}, true, call);
    });
}

winding_status winding_read_table(const char* path, int32_t normals_and_areas,
  const winding_run* run, winding_mesh** mesh, winding_refusal* refusal)
{
  return readFile(path, run, mesh, refusal,
    [normals_and_areas](const winding::InputFile& file, Call& call, winding_mesh& made) {
      readInto(made, file, {{}, true}, normals_and_areas != 0, call);
    });
}

void winding_column_init(winding_column* column, size_t size)
{
  fill(column, size, winding_column());
}

winding_status winding_mesh_column(
  const winding_mesh* mesh, int64_t index, winding_column* column, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const winding_mesh& from = required(mesh, "mesh");
      const winding_mesh::Column& found = itemAt(from.columns, index, "column_count");
      winding_column to = {};
      to.name = found.name.c_str();
      to.numbers = found.texts.empty() ? found.numbers.data() : nullptr;
      to.texts = found.texts.empty() ? nullptr : found.pointers.data();
      give(to, required(column, "column"));
    });
}

void winding_regions_init(winding_regions* regions, size_t size)
{
  fill(regions, size, winding_regions());
}

winding_status winding_mesh_regions(
  const winding_mesh* mesh, int64_t index, winding_regions* regions, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const winding_mesh& from = required(mesh, "mesh");
      const winding_mesh::Regions& found = itemAt(from.regions, index, "regions_count");
      winding_regions to = {};
      to.kind = found.kind;
      to.count = static_cast<int64_t>(found.names.size());
      to.names = found.pointers.data();
      to.of_polygon = pointerTo(found.ofPolygon);
      give(to, required(regions, "regions"));
    });
}
