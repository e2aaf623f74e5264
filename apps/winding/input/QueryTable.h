// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>

class Messages;
VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkWindingNumberReader;
VTK_ABI_NAMESPACE_END

/// A table of points that are asked about.
class QueryTable
{
public:
  /// The things that are wanted in addition to the points.
  enum class With
  {
    rows,   ///< texts of rows, to be handed on as they are
    columns ///< arrays of all columns
  };

  /// Reads the points from the chosen columns (vtkWindingNumberReader::SetColumns()). Throws
  /// Failure for whatever is no table of points.
  QueryTable(
    const std::string& fileName, With with, const std::string& columns, Messages& messages);
  ~QueryTable();

  vtkPointSet* points() const;

  /// Whether the table has a column of that name, or the points an array.
  bool hasColumn(const std::string& name) const;

  /// The text of the first row, without the end of its last line.
  const std::string& header() const { return header_; }

  /// The end of the first row's last line, "\n" or "\r\n".
  const char* lineEnd() const { return lineEnd_; }

  /// The letter between its fields.
  char separator() const;

  /// Whether commas are its decimal points.
  bool hasDecimalCommas() const;

  /// Returns the text of the row of `point`, without the end of its last line.
  std::string row(vtkIdType point) const;

private:
  vtkSmartPointer<vtkWindingNumberReader> reader_;
  std::string header_;
  const char* lineEnd_ = "\n";
};
