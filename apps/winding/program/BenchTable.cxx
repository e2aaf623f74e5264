// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/BenchTable.h"

#include "program/Threads.h"

#include <algorithm>
#include <cmath>

namespace
{

/// A value of a row for people.
std::string cellText(const Json& row, const std::string& column)
{
  const auto found = row.find(column);
  if (found == row.end() || found->is_null())
  {
    return "-";
  }
  if (found->is_string())
  {
    return found->get<std::string>();
  }
  if (!found->is_number_float())
  {
    return found->dump();
  }
  // A whole number is easier to read than a power of ten that takes as much room.
  const double value = found->get<double>();
  const bool isLarge = std::abs(value) >= 1000 && std::abs(value) < 1e7;
  return isLarge ? shown(std::round(value), 7) : shown(value, 4);
}

bool isText(const Json& row, const std::string& column)
{
  const auto found = row.find(column);
  return found != row.end() && found->is_string();
}

} // namespace

BenchTable::BenchTable(const std::string& title, const std::vector<std::string>& notes)
  : title_(title)
  , notes_(notes)
{
}

std::string BenchTable::text() const
{
  std::vector<std::string> columns;
  for (const Json& row : rows_)
  {
    for (const auto& item : row.items())
    {
      if (std::find(columns.begin(), columns.end(), item.key()) == columns.end())
      {
        columns.push_back(item.key());
      }
    }
  }
  std::vector<std::string> lines(rows_.size() + 1);
  for (const std::string& column : columns)
  {
    // Text begins at the left of its column, numbers end at the right.
    const bool left = std::any_of(
      rows_.begin(), rows_.end(), [&column](const Json& row) { return isText(row, column); });
    std::vector<std::string> cells = {column};
    std::size_t width = column.size();
    for (const Json& row : rows_)
    {
      cells.push_back(cellText(row, column));
      width = std::max(width, cells.back().size());
    }
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const std::string blank(width - cells[i].size(), ' ');
      lines[i] += (lines[i].empty() ? "" : "  ") + (left ? cells[i] + blank : blank + cells[i]);
    }
  }
  std::string text = title_ + "\n";
  for (const std::string& note : notes_)
  {
    text += "(" + note + ")\n";
  }
  for (const std::string& line : lines)
  {
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Json BenchTable::json() const
{
  return {{"title", title_}, {"notes", notes_}, {"rows", rows_}};
}

void printTables(const std::vector<BenchTable>& tables, int threads, bool asJson)
{
  Json json = {{"threads", threadsUsed(threads)}, {"tables", Json::array()}};
  std::string text;
  for (const BenchTable& table : tables)
  {
    json["tables"].push_back(table.json());
    text += (text.empty() ? "" : "\n") + table.text();
  }
  if (asJson)
  {
    print(json);
    return;
  }
  text.pop_back(); // print() ends the line
  print(text);
}
