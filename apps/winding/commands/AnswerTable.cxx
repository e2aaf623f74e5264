// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/AnswerTable.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "output/OutputFile.h"
#include "program/Interrupt.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <fstream>

namespace
{

constexpr std::size_t bytesAtOnce = 1 << 18;

} // namespace

void writeTable(const AnswerTable& table, OutputFile& file)
{
  std::optional<QueryTable>& queries = table.queries.table;
  vtkDataSet* const data = table.answer.data;
  const char separator = queries ? queries->separator() : separatorOf(file.name());
  const bool hasDecimalCommas = queries && queries->hasDecimalCommas();
  const char* const lineEnd = queries ? queries->lineEnd() : "\n";
  std::string text =
    queries ? queries->header() : std::string("x") + separator + "y" + separator + "z";
  std::vector<vtkDataArray*> results;
  for (const std::string& name : table.results)
  {
    results.push_back(data->GetPointData()->GetArray(name.c_str()));
    text += separator + asField(name, separator);
  }
  text += lineEnd;
  std::ofstream stream(file.temporaryName(), std::ios::binary);
  const auto write = [&]
  {
    interrupt::check();
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
    if (!stream)
    {
      file.refuseWriting();
    }
  };
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    if (table.isExtracted && !table.answer.inside[static_cast<std::size_t>(i)])
    {
      continue;
    }
    if (queries)
    {
      text += queries->row(i);
    }
    else
    {
      double point[3];
      data->GetPoint(i, point);
      text += exact(point, separator);
    }
    for (vtkDataArray* result : results)
    {
      text += separator;
      const std::size_t start = text.size();
      appendExact(text, result->GetTuple1(i));
      if (hasDecimalCommas)
      {
        std::replace(text.begin() + static_cast<std::ptrdiff_t>(start), text.end(), '.', ',');
      }
    }
    text += lineEnd;
    if (text.size() >= bytesAtOnce)
    {
      write();
    }
  }
  write();
  stream.close();
  if (!stream)
  {
    file.refuseWriting();
  }
}
