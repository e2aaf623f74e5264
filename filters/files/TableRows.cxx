// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/TableRows.h"

#include "base/Progress.h"
#include "files/OrderedBlocks.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace winding
{

namespace
{

[[noreturn]] void refuseQuotation(const InputFile& file, std::size_t offset)
{
  file.refuseLine(offset, "a quotation mark is not closed, or not at the end of its field");
}

/// The text from `first` on, of `bytes` bytes, or to the end of the file, behind which an end of
/// line is added.
TextBlock textFrom(const InputFile& file, std::size_t first, std::size_t bytes)
{
  const std::size_t count = std::min(bytes, file.size() - first);
  const bool isLast = first + count == file.size();
  PlainArray<char> text(count + (isLast ? 1 : 0));
  file.readText(first, text.data(), count);
  if (isLast)
  {
    text[count] = '\n';
  }
  return {std::move(text), first};
}

/// A stretch of whole rows.
struct Stretch
{
  std::size_t end = 0;   ///< the place behind it, blank lines included
  bool isBroken = false; ///< whether a quotation mark in the row there is not as it should be
};

/// Calls visit(rows) at the end of each whole row among `bytes` bytes from `start` on, until it
/// returns false.
template <class Visit>
Stretch visitWholeRows(
  const InputFile& file, std::size_t start, char separator, std::size_t bytes, const Visit& visit)
{
  const TextBlock text = textFrom(file, start, bytes);
  RowScanner rows(text.text(), separator);
  while (rows.nextRow() && rows.passRow() && visit(rows))
  {
  }
  const RowState state = rows.state();
  const char* const end = state == RowState::ended ? rows.rest().data() : rows.rowStart();
  const bool isLast = bytes >= file.size() - start;
  return {std::min(text.offsetOf(end), file.size()),
    state == RowState::broken || (isLast && state == RowState::cut)};
}

/// Calls take(row) for the first row from `start` on, if there is any. Returns the stretch up to
/// its end. Reads twice as much until the row ends.
template <class Take>
Stretch visitFirstRow(const InputFile& file, std::size_t start, char separator,
  std::size_t bytesAtOnce, const Take& take)
{
  bool isTaken = false;
  Stretch stretch{start};
  for (std::size_t bytes = bytesAtOnce; !isTaken && !stretch.isBroken && stretch.end < file.size();)
  {
    const std::size_t from = stretch.end;
    stretch = visitWholeRows(file, from, separator, bytes,
      [&](const RowScanner& row)
      {
        take(row);
        isTaken = true;
        return false;
      });
    bytes *= stretch.end == from ? 2 : 1;
  }
  return stretch;
}

} // namespace

TableHeader readTableHeader(const InputFile& file, char separator, std::size_t bytesAtOnce)
{
  TableHeader header;
  bool namesSeparator = false;
  const auto take = [&](const RowScanner& row)
  {
    const std::string_view text = contentOf(row.row());
    namesSeparator =
      text.size() == 5 && (text.substr(0, 4) == "sep=" || text.substr(0, 4) == "SEP=");
    header.text.assign(row.rowStart(), row.rest().data());
    RowScanner fields(header.text, separator);
    fields.nextRow();
    for (std::string_view field; fields.nextField(field);)
    {
      header.names.push_back(unquoted(field));
    }
  };
  Stretch first = visitFirstRow(file, file.textStart(), separator, bytesAtOnce, take);
  header.start = file.textStart();
  if (namesSeparator)
  {
    header = TableHeader();
    header.start = first.end;
    first = visitFirstRow(file, first.end, separator, bytesAtOnce, take);
  }
  if (first.isBroken)
  {
    refuseQuotation(file, first.end);
  }
  header.end = first.end;
  if (!header.names.empty() && header.names[0].rfind("//", 0) == 0)
  {
    header.names[0].erase(0, 2);
    header.names[0].erase(0, header.names[0].find_first_not_of(" \t"));
    bool isCount = false;
    const Stretch next = visitFirstRow(file, header.end, separator, bytesAtOnce,
      [&isCount](const RowScanner& row)
      {
        const std::string_view text = contentOf(row.row());
        isCount = !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
      });
    header.end = isCount ? next.end : header.end;
  }
  return header;
}

TableRows::TableRows(const InputFile& file, char separator, std::size_t start,
  std::size_t bytesPerBlock, Executor& executor)
  : file_(file)
  , separator_(separator)
  , blocks_(file, start, bytesPerBlock)
{
  Progress progress(executor);
  progress.set(0, 0.5);
  if (!this->countPlainRows(executor))
  {
    progress.set(0.5, 1);
    this->findQuotedRows(start, bytesPerBlock, executor);
  }
  for (std::size_t block = 0; block + 1 < starts_.size(); ++block)
  {
    starts_[block + 1] += starts_[block];
  }
}

/// Counts the rows of all blocks; false where a quotation mark stands in any of them.
bool TableRows::countPlainRows(Executor& executor)
{
  starts_.assign(blocks_.count() + 1, 0);
  std::atomic<bool> isPlain{true};
  runOrderedBlocks(
    blocks_.count(),
    [&](std::size_t block)
    {
      if (!isPlain)
      {
        return;
      }
      const TextBlock text = blocks_.read(block);
      if (text.text().find('"') != std::string_view::npos)
      {
        isPlain = false;
        return;
      }
      std::size_t count = 0; // blocks side by side would share a cache line of starts_
      for (RowScanner rows(text.text(), separator_); rows.nextRow() && rows.passLine();)
      {
        ++count;
      }
      starts_[block + 1] = count;
    },
    executor);
  return isPlain;
}

/// Makes blocks of whole rows in the order of the file, up to the first quotation mark that is not
/// as it should be.
void TableRows::findQuotedRows(std::size_t start, std::size_t bytesPerBlock, Executor& executor)
{
  starts_.assign(1, 0);
  std::vector<std::size_t> places = {start};
  Progress progress(executor);
  const auto shareOf = [&](std::size_t place)
  {
    return static_cast<double>(place) / static_cast<double>(file_.size());
  };
  std::size_t bytes = bytesPerBlock;
  while (!brokenRow_ && places.back() < file_.size())
  {
    const std::size_t from = places.back();
    std::size_t count = 0;
    Stretch stretch;
    progress.set(shareOf(from), shareOf(std::min(from + bytes, file_.size())));
    runOrderedBlocks(
      1,
      [&](std::size_t)
      {
        stretch = visitWholeRows(file_, from, separator_, bytes,
          [&count](const RowScanner&)
          {
            ++count;
            return true;
          });
      },
      executor);
    if (stretch.isBroken)
    {
      brokenRow_ = stretch.end;
    }
    if (stretch.end == from)
    {
      bytes *= 2;
      continue;
    }
    bytes = bytesPerBlock;
    places.push_back(stretch.end);
    starts_.push_back(count);
  }
  blocks_ = LineBlocks(file_, std::move(places));
}

void TableRows::checkEnd() const
{
  if (brokenRow_)
  {
    refuseQuotation(file_, *brokenRow_);
  }
}

void TableRows::visit(const std::function<void(Part& part)>& work, Executor& executor) const
{
  runOrderedBlocks(
    blocks_.count(),
    [&](std::size_t block)
    {
      Part part(file_, blocks_.read(block), separator_, starts_[block], starts_[block + 1]);
      work(part);
    },
    executor);
}

TableRows::Part::Part(
  const InputFile& file, TextBlock text, char separator, std::size_t first, std::size_t last)
  : file_(file)
  , text_(std::move(text))
  , fields_(text_.text(), separator)
  , separator_(separator)
  , next_(first)
  , last_(last)
{
}

bool TableRows::Part::nextRow()
{
  const bool isThere = fields_.nextRow();
  if (isThere != (next_ < last_))
  {
    file_.refuseChanged();
  }
  next_ += isThere ? 1 : 0;
  return isThere;
}

std::size_t TableRows::Part::countFields() const
{
  const char* const end = text_.text().data() + text_.text().size();
  RowScanner row(
    {fields_.rowStart(), static_cast<std::size_t>(end - fields_.rowStart())}, separator_);
  row.nextRow();
  std::size_t count = 0;
  for (std::string_view field; row.nextField(field);)
  {
    ++count;
  }
  if (row.state() != RowState::ended)
  {
    refuseQuotation(file_, this->offset());
  }
  return count;
}

void TableRows::Part::refuse(const std::string& message) const
{
  file_.refuseLine(this->offset(), message);
}

} // namespace winding
