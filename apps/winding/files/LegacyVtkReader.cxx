// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/LegacyVtkReader.h"

#include "files/Text.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>
#include <string_view>

vtkStandardNewMacro(LegacyVtkReader);

namespace
{

/// A number that stands for another one which VTK does not read. No file has it.
struct Substitute
{
  const char* text;
  double number;
  double original;
};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Substitute notANumber = {
  "2.718281828459e38", 2.718281828459e38, std::numeric_limits<double>::quiet_NaN()};
constexpr Substitute positive = {"3.141592653589e38", 3.141592653589e38, infinity};
constexpr Substitute negative = {"-3.141592653589e38", -3.141592653589e38, -infinity};

/// Returns what stands for a word that C++ writes for a number that is not finite; null for others.
const Substitute* substituteFor(std::string_view word)
{
  const bool isNegative = !word.empty() && word[0] == '-';
  const std::string letters = inSmallLetters(word.substr(isNegative || word[0] == '+' ? 1 : 0));
  if (letters == "inf" || letters == "infinity")
  {
    return isNegative ? &negative : &positive;
  }
  return letters.rfind("nan", 0) == 0 && (letters.size() == 3 || letters[3] == '(') ? &notANumber
                                                                                    : nullptr;
}

/// Whether a line is of numbers alone, and some are not finite.
bool needsSubstitutes(std::string_view line)
{
  bool needsAny = false;
  for (auto word = takeWord(line); !word.empty(); word = takeWord(line))
  {
    const bool isSubstituted = substituteFor(word) != nullptr;
    const char first = word[0];
    if (!isSubstituted && !std::isdigit(static_cast<unsigned char>(first)) && first != '-' &&
        first != '+' && first != '.')
    {
      return false;
    }
    needsAny |= isSubstituted;
  }
  return needsAny;
}

/// Whether a legacy file is of text.
bool isText(const std::string& fileName)
{
  const std::string head = beginningOf(fileName, 1024);
  std::size_t start = 0;
  takeLine(head, start); // the version
  takeLine(head, start); // the title, which may be any
  std::string_view way = takeLine(head, start);
  return inSmallLetters(takeWord(way)) == "ascii";
}

/// Returns a file of text with substitutes for numbers that are not finite; empty where it needs
/// none.
std::string withSubstitutes(std::string_view text)
{
  std::string result;
  std::size_t start = 0, done = 0;
  // The words in question have this letter, and finite numbers have not.
  while ((start = text.find_first_of("nN", start)) != std::string_view::npos)
  {
    const std::size_t begin = text.rfind('\n', start) + 1;
    start = begin;
    std::string_view line = takeLine(text, start);
    if (line.size() > 6 && endsWith(line, "string"))
    {
      return "";
    }
    if (!needsSubstitutes(line))
    {
      continue;
    }
    result += text.substr(done, begin - done);
    for (auto word = takeWord(line); !word.empty(); word = takeWord(line))
    {
      const Substitute* const substitute = substituteFor(word);
      result += (substitute ? std::string_view(substitute->text) : word);
      result += ' ';
    }
    result += '\n';
    done = start;
  }
  return done == 0 ? "" : result.append(text.substr(done));
}

template <class Array> void restoreValues(Array* array)
{
  using Value = typename Array::ValueType;
  Value* const begin = array->GetPointer(0);
  for (const Substitute& substitute : {notANumber, positive, negative})
  {
    std::replace(begin, begin + array->GetNumberOfValues(), static_cast<Value>(substitute.number),
      static_cast<Value>(substitute.original));
  }
}

void restore(vtkAbstractArray* array)
{
  if (auto* const floats = vtkFloatArray::SafeDownCast(array))
  {
    restoreValues(floats);
  }
  else if (auto* const doubles = vtkDoubleArray::SafeDownCast(array))
  {
    restoreValues(doubles);
  }
}

} // namespace

LegacyVtkReader::LegacyVtkReader()
{
  // By default the reader takes the first array of each kind only.
  this->ReadAllScalarsOn();
  this->ReadAllVectorsOn();
  this->ReadAllNormalsOn();
  this->ReadAllFieldsOn();
}

int LegacyVtkReader::ReadMeshSimple(const std::string& fileName, vtkDataObject* output)
{
  const std::string changed = isText(fileName) ? withSubstitutes(contentsOf(fileName)) : "";
  const bool isChanged =
    !changed.empty() && changed.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max());
  if (isChanged)
  {
    this->SetInputString(changed.data(), static_cast<int>(changed.size()));
    this->ReadFromInputStringOn();
  }
  const int isRead = this->Superclass::ReadMeshSimple(fileName, output);
  auto* const data = vtkDataSet::SafeDownCast(output);
  if (!isChanged || !data)
  {
    return isRead;
  }
  if (auto* const points = vtkPointSet::SafeDownCast(data); points && points->GetPoints())
  {
    restore(points->GetPoints()->GetData());
  }
  for (vtkFieldData* const arrays : {static_cast<vtkFieldData*>(data->GetPointData()),
         static_cast<vtkFieldData*>(data->GetCellData()), data->GetFieldData()})
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      restore(arrays->GetAbstractArray(i));
    }
  }
  return isRead;
}
