// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// A fuzzer of tables: all that can be asked of one, in blocks of any size, and the rows.

#include "FuzzedFile.h"

#include "base/Executor.h"
#include "support/KeptTexts.h"
#include "support/Serial.h"

#include <cstring>
#include <optional>
#include <string>

namespace
{

using shapes::serial;
using winding::PlainArray;
using winding::PointTable;

/// The table, or what is wrong with it.
struct Read
{
  std::optional<PointTable> table;
  KeptTexts texts;
  std::string refusal;
};

Read read(const fuzz::FuzzedFile& file, winding::TableOptions options)
{
  Read result;
  options.texts = &result.texts;
  try
  {
    const winding::InputFile input(file.name().c_str());
    result.table = winding::readPointTable(input, options, serial);
  }
  catch (const winding::FileRefusal& refusal)
  {
    result.refusal = refusal.what();
  }
  return result;
}

void require(bool isTrue)
{
  if (!isTrue)
  {
    __builtin_trap();
  }
}

/// Whether arrays have the same bits, NaN included.
template <class Number> bool same(const PlainArray<Number>& a, const PlainArray<Number>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

void requireSame(const PointTable& a, const PointTable& b)
{
  require(same(a.points.points.doubles, b.points.points.doubles));
  require(same(a.points.normals.doubles, b.points.normals.doubles));
  require(same(a.points.areas, b.points.areas));
  require(a.rows == b.rows);
  require(a.header == b.header && a.names == b.names && a.columns.size() == b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i)
  {
    require(a.columns[i].name == b.columns[i].name && a.columns[i].isText == b.columns[i].isText);
    require(same(a.columns[i].numbers, b.columns[i].numbers));
  }
}

/// The header and the rows one after the other are a table of the same points.
void requireWholeRows(const PointTable& table, const winding::TableOptions& options)
{
  std::string joined = table.header;
  for (const std::string_view row : table.rows)
  {
    joined.append(row) += '\n';
  }
  static const fuzz::FuzzedFile file(".joined");
  file.write(reinterpret_cast<const std::uint8_t*>(joined.data()), joined.size());
  const Read again = read(file, options);
  require(again.table.has_value());
  require(same(table.points.points.doubles, again.table->points.points.doubles));
  require(same(table.points.normals.doubles, again.table->points.normals.doubles));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  static const fuzz::FuzzedFile file(".csv");
  file.write(data, size);
  winding::TableOptions options;
  options.separator = size % 4 == 3 ? '\t' : ',';
  options.normalsAndAreas = size % 3 != 0;
  options.rows = true;
  options.columns = size % 5 == 4 ? winding::ColumnChoice("x=1 y=2 z=3") : winding::ColumnChoice();
  const Read whole = read(file, options);
  options.bytesPerBlock = 1 + data[size / 2] % 64;
  const Read inBlocks = read(file, options);
  require(whole.refusal == inBlocks.refusal);
  if (whole.table)
  {
    requireSame(*whole.table, *inBlocks.table);
    require(whole.texts.all() == inBlocks.texts.all());
    requireWholeRows(*whole.table, options);
  }
  return 0;
}
