// A fuzzer of tables: all that can be asked of one.

#include "FuzzedFile.h"

#include "input/Table.h"
#include "program/Failure.h"

#include "vtkDoubleArray.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const fuzz::FuzzedFile commas(".csv"), tabs(".tsv");
  const fuzz::FuzzedFile& file = size % 4 == 3 ? tabs : commas;
  file.write(data, size);
  try
  {
    const Table table(file.name());
    for (std::size_t column = 0; column < table.columns(); ++column)
    {
      const auto rows = static_cast<vtkIdType>(table.rows());
      if (table.isNumeric(column) && table.numbers({column})->GetNumberOfTuples() != rows)
      {
        __builtin_trap();
      }
      if (table.texts(column).size() != table.rows())
      {
        __builtin_trap();
      }
    }
    cloudFrom(table);
  }
  catch (const Failure&)
  {
  }
  return 0;
}
