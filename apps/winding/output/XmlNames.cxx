// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/XmlNames.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <string>

namespace
{

/// The number of bytes of the character of UTF-8 that begins at a place; 0 if there is none.
std::size_t lengthOfCharacter(const std::string& text, std::size_t at)
{
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  for (std::size_t i = 1; i < length; ++i)
  {
    if (at + i >= text.size() || (static_cast<unsigned char>(text[at + i]) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  return length;
}

std::string escaped(const std::string& name)
{
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    const auto c = static_cast<unsigned char>(name[i]);
    const std::size_t length = lengthOfCharacter(name, i);
    const bool isMark = c == '"' || c == '<' || c == '>' || c == '&';
    if (length == 0 || isMark)
    {
      text += "&#" + std::to_string(c) + ";";
    }
    else if (c < ' ')
    {
      text += '?';
    }
    else
    {
      text += name.substr(i, length);
      i += length - 1;
    }
  }
  return text;
}

void prepare(vtkFieldData* arrays)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetName())
    {
      array->SetName(escaped(array->GetName()).c_str());
    }
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      if (const char* name = array->GetComponentName(component))
      {
        array->SetComponentName(component, escaped(name).c_str());
      }
    }
  }
}

} // namespace

std::string escapedForXml(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    switch (c)
    {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  }
  return result;
}

void prepareNamesForXml(vtkDataSet* data)
{
  prepare(data->GetPointData());
  prepare(data->GetCellData());
  prepare(data->GetFieldData());
}
