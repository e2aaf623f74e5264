// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands/DealtProbe.h"
#include "input/QueryTable.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <optional>
#include <string>
#include <vector>

class OutputFile;
VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

/// The points asked about, and the table that they come from, if they come from one.
struct Queries
{
  std::optional<QueryTable> table;
  vtkSmartPointer<vtkDataSet> points;
};

/// The rows of an answer, which are the queries' as they came in, or the coordinates of
/// points that came in otherwise, with a column more for each result.
struct AnswerTable
{
  Queries& queries;
  const ProbeAnswer& answer;
  std::vector<std::string> results; ///< the names of their arrays
  bool isExtracted;                 ///< whether the answer has only what is inside
};

/// Writes a table, with the separators and decimal points of the queries, or by the suffix of the
/// file if these are no table; commit() is left to the caller. Throws Failure when the file cannot
/// be written whole, or the program is interrupted.
void writeTable(const AnswerTable& table, OutputFile& file);
