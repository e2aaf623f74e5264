// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandTree.h"

#include "options/CommandLine.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <regex>
#include <set>

namespace
{

constexpr int many = 1000; // values; CLI11 counts on to its own, larger limit

std::vector<std::string> namesOf(const CLI::Option& option)
{
  if (!option.nonpositional())
  {
    return {option.get_name()};
  }
  std::vector<std::string> names;
  for (const std::string& letter : option.get_snames())
  {
    names.push_back("-" + letter);
  }
  for (const std::string& word : option.get_lnames())
  {
    names.push_back("--" + word);
  }
  return names;
}

/// Returns the names of options, sorted: CLI11 has them in the order of their addresses.
std::vector<std::string> sortedNames(const std::set<CLI::Option*>& options)
{
  std::set<std::string> names;
  for (const CLI::Option* option : options)
  {
    names.insert(option->get_name());
  }
  return {names.begin(), names.end()};
}

/// Returns the words that an option takes: the name of its validator, if it has one (oneOf()).
std::vector<std::string> choicesOf(CLI::Option& option)
{
  try
  {
    return CLI::detail::split(option.get_validator(0)->get_name(), ' ');
  }
  catch (const CLI::OptionNotFound&)
  {
    return {};
  }
}

/// Returns the suffixes that a help names, without their dots.
std::vector<std::string> suffixesIn(const std::string& help)
{
  static const std::regex suffix(R"((^|\s)\.([a-z][a-z0-9]*(\.gz)?|3mf)\b)");
  std::vector<std::string> suffixes;
  for (std::sregex_iterator found(help.begin(), help.end(), suffix), end; found != end; ++found)
  {
    if (std::find(suffixes.begin(), suffixes.end(), (*found)[2]) == suffixes.end())
    {
      suffixes.push_back((*found)[2]);
    }
  }
  return suffixes;
}

OptionEntry entryOf(CLI::Option& option)
{
  OptionEntry entry;
  entry.names = namesOf(option);
  entry.help = option.get_description();
  entry.group = option.get_group();
  entry.isPositional = option.get_positional();
  entry.isRequired = option.get_required();
  entry.mostValues = std::min(option.get_items_expected_max(), many);
  entry.values = entry.mostValues == 0 ? "" : option.get_type_name();
  entry.choices = choicesOf(option);
  static const std::set<std::string> files = {"OUT", "IMAGE", "X Y Z | FILE | up"};
  entry.isFile = entry.isPositional || files.count(entry.values) > 0;
  if (entry.isFile)
  {
    entry.suffixes = suffixesIn(entry.help);
  }
  entry.excluded = sortedNames(option.get_excludes());
  entry.needed = sortedNames(option.get_needs());
  return entry;
}

CommandEntry entryOf(CLI::App& app)
{
  CommandEntry entry;
  entry.name = app.get_name();
  entry.help = app.get_description();
  for (CLI::Option* option : app.get_options())
  {
    entry.options.push_back(entryOf(*option));
  }
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
  {
    entry.commands.push_back(entryOf(*command));
  }
  return entry;
}

} // namespace

CommandEntry describeProgram()
{
  Options options;
  CLI::App app;
  addCommands(app, options);
  return entryOf(app);
}

std::string briefHelp(const std::string& help)
{
  static const std::regex detail(R"([:;]\s|\.\s|\s\()");
  std::smatch found;
  return std::regex_search(help, found, detail) ? std::string(found.prefix()) : help;
}
