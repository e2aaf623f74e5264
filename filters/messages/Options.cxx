// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "messages/Options.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace winding
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns what setters call a constant: SpanningTree for SPANNING_TREE. They leave out the
/// beginning that only distinguishes it from constants of other options.
std::string inSetter(const std::string& constant)
{
  std::size_t first = 0;
  for (const std::string beginning : {"DISTRIBUTION_", "ESTIMATION_", "LABELS_", "VTK_"})
  {
    first = constant.rfind(beginning, 0) == 0 ? beginning.size() : first;
  }
  std::string name;
  for (std::size_t n = first; n < constant.size(); ++n)
  {
    const bool isFirst = n == first || constant[n - 1] == '_';
    if (constant[n] != '_')
    {
      name += static_cast<char>(isFirst ? constant[n] : constant[n] - 'A' + 'a');
    }
  }
  return name;
}

/// The label of a list entry, which ends with a mark if its box is behind the gear.
struct Label
{
  explicit Label(std::string text)
    : isBehindGear(!text.empty() && text.back() == '*')
    , words(text.substr(0, text.size() - (isBehindGear ? 1 : 0)))
  {
  }

  bool isBehindGear;
  std::string words;
};

std::vector<Option> makeOptions()
{
  std::vector<Option> options;
#define OPTION(                                                                                    \
  parameter, property, kind, standard, lowest, highest, unit, label, option, keyword, help)        \
  options.push_back({Parameter::parameter, property, OptionKind::kind, standard, lowest, highest,  \
    Label(label).words, Label(label).isBehindGear, option, keyword, {}});
#define CHOICE(parameter, number, constant, entry, word)                                           \
  options.back().choices.push_back({number, constant, entry, word, inSetter(constant)});
#define OTHER(parameter, cxx, label, option, keyword, c)
#include "Options.def"
#undef OPTION
#undef CHOICE
#undef OTHER
  return options;
}

/// A thing with names that is no option.
struct Other
{
  Parameter parameter;
  std::array<const char*, 5> names; ///< by front end
};

constexpr Other others[] = {
#define OPTION(...)
#define CHOICE(...)
#define OTHER(parameter, cxx, label, option, keyword, c)                                           \
  {Parameter::parameter, {cxx, label, option, keyword, c}},
#include "Options.def"
#undef OPTION
#undef CHOICE
#undef OTHER
};

const char* nameOfOther(Parameter parameter, FrontEnd frontEnd)
{
  const auto* found = std::find_if(std::begin(others), std::end(others),
    [parameter](const Other& other) { return other.parameter == parameter; });
  return found == std::end(others) ? "" : found->names[static_cast<std::size_t>(frontEnd)];
}

const Choice* choiceOf(const Option& option, std::optional<int> number)
{
  const auto found = std::find_if(option.choices.begin(), option.choices.end(),
    [number](const Choice& choice) { return number == choice.number; });
  return found == option.choices.end() ? nullptr : &*found;
}

/// Returns the number that a setting proposes; empty for flags, and where it proposes none.
std::string numberOf(const Option& option, const Setting& setting)
{
  return setting.value && option.kind != OptionKind::flag ? std::to_string(*setting.value) : "";
}

std::string inCxx(const Option& option, const Setting& setting)
{
  const std::string property = option.property;
  if (const std::string number = numberOf(option, setting); !number.empty())
  {
    const Choice* choice = choiceOf(option, setting.value);
    return "Set" + property + "(" + (choice ? choice->constant : number) + ")";
  }
  return setting.value ? property + (*setting.value != 0 ? "On()" : "Off()")
                       : "Set" + property + "()";
}

std::string inParaView(const Option& option, const Setting& setting)
{
  const std::string& label = option.label;
  if (const Choice* choice = choiceOf(option, setting.value))
  {
    return label + ": " + choice->entry;
  }
  const std::string number = numberOf(option, setting);
  if (!number.empty())
  {
    return label + ": " + number;
  }
  return setting.value == 0 ? label + " off" : label;
}

std::string inProgram(const Option& option, const Setting& setting)
{
  const std::string name = option.option;
  if (const Choice* choice = choiceOf(option, setting.value))
  {
    return *choice->word ? name + " " + choice->word : name;
  }
  const std::string number = numberOf(option, setting);
  if (!number.empty())
  {
    return name + " " + number;
  }
  return setting.value && std::to_string(*setting.value) == option.standard ? "no " + name : name;
}

std::string inPython(const Option& option, const Setting& setting)
{
  const std::string name = std::string(option.keyword) + "=";
  if (const Choice* choice = choiceOf(option, setting.value))
  {
    return name + "'" + choice->word + "'";
  }
  const std::string number = numberOf(option, setting);
  if (!number.empty())
  {
    return name + number;
  }
  return setting.value ? name + (*setting.value != 0 ? "True" : "False") : name;
}

/// Returns a name with words in capitals, as "NormalEstimation", with underscores between them.
std::string withUnderscores(const std::string& name)
{
  std::string result;
  for (const char letter : name)
  {
    const bool isCapital = letter >= 'A' && letter <= 'Z';
    result += isCapital && !result.empty() ? "_" : "";
    result += static_cast<char>(isCapital ? letter - 'A' + 'a' : letter);
  }
  return result;
}

std::string inC(const Option& option, const Setting& setting)
{
  const std::string name = withUnderscores(option.property);
  if (!setting.value)
  {
    return name;
  }
  std::string value = std::to_string(*setting.value);
  if (const Choice* choice = choiceOf(option, setting.value); choice && *choice->word)
  {
    value = "WINDING_" + name + "_" + choice->word;
    for (char& letter : value)
    {
      letter = static_cast<char>(letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter);
    }
  }
  return name + " = " + value;
}

/// Returns whether a box is one that a user of ParaView does not see.
bool isHidden(const Setting& setting, FrontEnd frontEnd)
{
  const Option* const option = optionOf(setting.parameter);
  return frontEnd == FrontEnd::paraview && option && option->isBehindGear;
}

/// Returns the names of the settings that a front end has. Hidden boxes are named where none of
/// the others is seen.
std::string namesOf(const std::vector<Setting>& settings, FrontEnd frontEnd)
{
  std::string seen, hidden;
  for (const Setting& setting : settings)
  {
    std::string& names = isHidden(setting, frontEnd) ? hidden : seen;
    const std::string name = howTo(setting, frontEnd);
    names += names.empty() || name.empty() ? name : ", " + name;
  }
  return seen.empty() && !hidden.empty() ? hidden + ", behind the gear" : seen;
}

/// A remedy in words, or nothing where a front end does not have it.
std::string textOf(const Remedy& remedy, FrontEnd frontEnd)
{
  const std::string names = namesOf(remedy.settings, frontEnd);
  if (names.empty())
  {
    return remedy.words;
  }
  return remedy.words.empty() ? "use " + names : remedy.words + " (" + names + ")";
}

thread_local FrontEnd frontEndOfThread = FrontEnd::cxx;

} // namespace

const Option* optionOf(Parameter parameter)
{
  static const std::vector<Option> options = makeOptions();
  const auto found = std::find_if(options.begin(), options.end(),
    [parameter](const Option& option) { return option.parameter == parameter; });
  return found == options.end() ? nullptr : &*found;
}

const char* nameOfChoice(Parameter parameter, int number)
{
  const Option* const option = optionOf(parameter);
  const Choice* const choice = option ? choiceOf(*option, number) : nullptr;
  return choice ? choice->setter.c_str() : "Unknown";
}

std::string nameOf(Parameter parameter, FrontEnd frontEnd)
{
  const Option* option = optionOf(parameter);
  if (!option)
  {
    return nameOfOther(parameter, frontEnd);
  }
  switch (frontEnd)
  {
  case FrontEnd::paraview:
    return option->label;
  case FrontEnd::program:
    return option->option;
  case FrontEnd::python:
    return option->keyword;
  case FrontEnd::c:
    return withUnderscores(option->property);
  case FrontEnd::cxx:
    break;
  }
  return option->property;
}

std::string howTo(const Setting& setting, FrontEnd frontEnd)
{
  const Option* option = optionOf(setting.parameter);
  const std::string name = nameOf(setting.parameter, frontEnd);
  if (!option || name.empty())
  {
    return name;
  }
  switch (frontEnd)
  {
  case FrontEnd::paraview:
    return inParaView(*option, setting);
  case FrontEnd::program:
    return inProgram(*option, setting);
  case FrontEnd::python:
    return inPython(*option, setting);
  case FrontEnd::c:
    return inC(*option, setting);
  case FrontEnd::cxx:
    break;
  }
  return inCxx(*option, setting);
}

std::string lineOf(const Message& message, FrontEnd frontEnd)
{
  std::string line;
  if (message.subject)
  {
    // A front end without the option cannot set it either, unless it reaches the property itself.
    const std::string name = nameOf(*message.subject, frontEnd);
    line = (name.empty() ? nameOf(*message.subject, FrontEnd::cxx) : name) + " ";
  }
  line += message.fault;
  const char* before = ": ";
  for (const Remedy& remedy : message.remedies)
  {
    const std::string text = textOf(remedy, frontEnd);
    if (!text.empty())
    {
      line += before + text;
      before = ", or ";
    }
  }
  return message.facts.empty() ? line : line + "; " + message.facts;
}

FrontEndScope::FrontEndScope(FrontEnd frontEnd)
  : before_(std::exchange(frontEndOfThread, frontEnd))
{
}

FrontEndScope::~FrontEndScope()
{
  frontEndOfThread = before_;
}

FrontEnd frontEnd()
{
  return frontEndOfThread;
}

bool isEstimateAsked()
{
  return frontEnd() != FrontEnd::paraview;
}

std::string lineOf(const Message& message)
{
  return lineOf(message, frontEnd());
}

std::string lineOf(const std::vector<Message>& messages)
{
  std::string line;
  for (const Message& message : messages)
  {
    line += (line.empty() ? "" : "; ") + lineOf(message);
  }
  return line;
}

} // namespace winding
