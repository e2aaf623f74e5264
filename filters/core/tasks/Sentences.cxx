// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/Sentences.h"

#include "diagnosis/GridAdvice.h"

#include <algorithm>
#include <stdexcept>

namespace winding
{

namespace
{

struct Entry
{
  const char* name;
  Message message;
};

Remedy anotherRegionArray()
{
  return {"choose another array of regions", {Parameter::regionArray}};
}

const std::vector<Entry>& entries()
{
  static const std::vector<Entry> all = {
#define SENTENCE(name, fault, facts, ...) {#name, {fault, std::vector<Remedy>{__VA_ARGS__}, facts}},
#include "tasks/Sentences.def"
#undef SENTENCE
  };
  return all;
}

/// Replaces {0}, {1} … in `text` by values. The texts of values stay as they are.
std::string filled(const std::string& text, const std::vector<std::string>& values)
{
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
  {
    const bool isPlace = text[at] == '{' && at + 2 < text.size() && text[at + 2] == '}';
    const auto value = isPlace ? static_cast<std::size_t>(text[at + 1] - '0') : values.size();
    if (value < values.size())
    {
      result += values[value];
      at += 2;
    }
    else
    {
      result += text[at];
    }
  }
  return result;
}

Message filled(Message message, const std::vector<std::string>& values)
{
  message.fault = filled(message.fault, values);
  message.facts = filled(message.facts, values);
  return message;
}

} // namespace

Message messageOf(Sentence sentence, const std::vector<std::string>& values)
{
  return filled(entries()[static_cast<std::size_t>(sentence)].message, values);
}

Message messageOf(const std::string& sentence, const std::vector<std::string>& values)
{
  const auto found = std::find_if(entries().begin(), entries().end(),
    [&sentence](const Entry& entry) { return sentence == entry.name; });
  if (found == entries().end())
  {
    throw std::out_of_range("there is no sentence '" + sentence + "'");
  }
  return filled(found->message, values);
}

} // namespace winding
