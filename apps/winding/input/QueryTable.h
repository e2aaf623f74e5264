#pragma once

#include "files/OpenFile.h"

#include "vtkSmartPointer.h"

#include <string>
#include <string_view>

class Messages;
class vtkPointSet;
class vtkPointTableReader;
class vtkTypeInt64Array;

/// A table of points that are asked about. Its rows stay in the file, from where they can be handed
/// on as they are.
class QueryTable
{
public:
  /// Reads the points, and with `withColumns` all other columns as arrays of theirs. Throws Failure
  /// for whatever is no table of points, and where it changes meanwhile.
  QueryTable(const std::string& fileName, bool withColumns, Messages& messages);
  ~QueryTable();

  vtkPointSet* points() const;

  bool hasColumn(const std::string& name) const;

  /// The text of the first row, without the end of its last line.
  const std::string& header() const { return header_; }

  /// The end of the first row, and so that of all.
  const char* lineEnd() const { return lineEnd_; }

  /// The text of the row of a point, without the end of its last line, valid until the next call.
  std::string_view row(vtkIdType point);

  /// Throws Failure where something was written into the file since it was read, so that rows may
  /// not be those of the points.
  void checkRows() const { file_.checkIsUnchanged(); }

private:
  OpenFile file_;
  vtkSmartPointer<vtkPointTableReader> reader_;
  vtkSmartPointer<vtkTypeInt64Array> places_;
  std::string header_;
  const char* lineEnd_ = "\n";
};
