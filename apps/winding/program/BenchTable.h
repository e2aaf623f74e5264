// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/Print.h"

#include <string>
#include <vector>

/**
 * A table of measurements: aligned columns for people, an array of objects for machines. A row is
 * an object; its names are the columns', which stand in the order in which they first occur.
 */
class BenchTable
{
public:
  /// The notes say what was measured and how; each is a line.
  BenchTable(const std::string& title, const std::vector<std::string>& notes);

  void add(const Json& row) { rows_.push_back(row); }

  /// The table for people: numbers with four digits, "-" where a row has nothing in a column.
  std::string text() const;

  /// The table for machines: title, notes and rows.
  Json json() const;

private:
  std::string title_;
  std::vector<std::string> notes_;
  std::vector<Json> rows_;
};

/// Prints tables for people, or as JSON together with the number of threads that `threads` stands
/// for.
void printTables(const std::vector<BenchTable>& tables, int threads, bool asJson);
