// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/TemporaryFile.h"

#include "base/Executor.h"
#include "files/InputFile.h"
#include "files/MeshArrays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

/**
 * @file
 * The results of parsers for files of some contents, and their words for those that they refuse.
 */

using Parser = winding::MeshArrays (*)(const winding::InputFile& file, winding::Executor& executor);
using Ids = std::vector<std::int64_t>;

inline winding::MeshArrays parsed(
  Parser parser, const std::string& contents, winding::Executor& executor)
{
  const TemporaryFile file(contents);
  return parser(winding::InputFile(file.name()), executor);
}

inline winding::MeshArrays parsed(Parser parser, const std::string& contents)
{
  winding::SerialExecutor serial;
  return parsed(parser, contents, serial);
}

template <class Number> std::vector<Number> vectorOf(const winding::PlainArray<Number>& array)
{
  return {array.begin(), array.end()};
}

inline void expectCells(
  const winding::CellArrays& cells, const Ids& offsets, const Ids& connectivity)
{
  EXPECT_EQ(vectorOf(cells.offsets), offsets);
  EXPECT_EQ(vectorOf(cells.connectivity), connectivity);
}

inline void expectSame(const winding::MeshArrays& a, const winding::MeshArrays& b)
{
  EXPECT_EQ(vectorOf(a.points.doubles), vectorOf(b.points.doubles));
  EXPECT_EQ(vectorOf(a.points.floats), vectorOf(b.points.floats));
  EXPECT_EQ(vectorOf(a.normals.doubles), vectorOf(b.normals.doubles));
  EXPECT_EQ(vectorOf(a.normals.floats), vectorOf(b.normals.floats));
  for (const auto cells :
    {&winding::MeshArrays::vertices, &winding::MeshArrays::lines, &winding::MeshArrays::polygons})
  {
    expectCells(a.*cells, vectorOf((b.*cells).offsets), vectorOf((b.*cells).connectivity));
  }
}

/// The words of a parser for contents that it refuses, without the name of the file; none if it
/// takes them.
inline std::string refusalOf(
  Parser parser, const std::string& contents, winding::Executor& executor)
{
  const TemporaryFile file(contents);
  try
  {
    parser(winding::InputFile(file.name()), executor);
  }
  catch (const winding::FileRefusal& refusal)
  {
    const std::string message = refusal.what(), name = std::string(file.name()) + ": ";
    EXPECT_EQ(message.rfind(name, 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(std::min(message.size(), name.size()));
  }
  return "";
}

inline std::string refusalOf(Parser parser, const std::string& contents)
{
  winding::SerialExecutor serial;
  return refusalOf(parser, contents, serial);
}
