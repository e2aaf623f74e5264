#pragma once

#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class vtkDoubleArray;
class vtkPolyData;

/**
 * A text table with a header row: .csv with commas, .tsv with tabs. The text of its rows stays
 * unchanged, so that columns that are not understood can be handed on. Quoted fields may have
 * separators and ends of lines in them (TableText.h). Rows and numbers are read by all threads;
 * with a quotation mark anywhere in the file its rows are found by one.
 */
class Table
{
public:
  /// Throws Failure for files that cannot be read, quotation marks that are not closed, and rows
  /// with more or fewer fields than the header.
  explicit Table(const std::string& fileName);

  std::size_t rows() const { return rows_.size(); }
  std::size_t columns() const { return names_.size(); }
  const std::string& name(std::size_t column) const { return names_[column]; }

  /// The column of that name, if there is one.
  std::optional<std::size_t> find(const std::string& name) const;

  /// The column that means x, y, z, nx, ny, nz or area, if there is one: in small letters or large
  /// ones, or by ParaView's names of the components of points and normals ("Points:0",
  /// "Normals:2").
  std::optional<std::size_t> findMeaning(const std::string& name) const;

  /// Columns as the components of one array. Throws Failure, naming the first line with a field
  /// that is no number.
  vtkSmartPointer<vtkDoubleArray> numbers(const std::vector<std::size_t>& columns) const;

  /// The fields of a column as they say, without quotation marks around them.
  std::vector<std::string> texts(std::size_t column) const;

  /// Whether all fields of a column are numbers.
  bool isNumeric(std::size_t column) const;

  /// One point per row from the columns x, y and z, in double precision, all in one vertex cell.
  /// Throws Failure without these columns.
  vtkSmartPointer<vtkPolyData> points() const;

  char separator() const { return separator_; }
  std::string_view header() const { return header_; }

  /// The text of a row, without the end of its last line.
  std::string_view row(std::size_t index) const { return rows_[index]; }

  /// The end of the file's lines.
  const char* lineEnd() const { return lineEnd_; }

private:
  /// Finds all rows of a part of the text.
  std::vector<std::string_view> rowsOf(std::string_view part) const;
  void readRows(std::string_view text);

  /// Throw Failure about the line in which a row begins.
  [[noreturn]] void refuseRow(std::string_view row, const std::string& message) const;
  [[noreturn]] void refuseQuotation(std::string_view row) const;

  std::optional<std::size_t> findIf(
    const std::function<bool(const std::string& column)>& isWanted) const;

  std::string fileName_;
  std::string text_;
  char separator_;
  const char* lineEnd_;
  std::string_view header_;
  std::vector<std::string> names_;
  std::vector<std::string_view> rows_;
};

/// A source from a table: points, with normals from the columns nx, ny and nz and areas from the
/// column area where there are such.
vtkSmartPointer<vtkPolyData> cloudFrom(const Table& table);
