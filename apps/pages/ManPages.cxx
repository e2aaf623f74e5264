// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pages.h"

#include "program/Failure.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace
{

bool isLetter(const std::string& text, std::size_t at)
{
  return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at]));
}

/// Returns text for roff. Hyphens between letters stay. All others are minus signs, which can be
/// searched for and copied into a shell.
std::string escaped(const std::string& text)
{
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
  {
    if (text[at] == '\\')
    {
      result += "\\e";
    }
    else if (text[at] == '-' && (at == 0 || !isLetter(text, at - 1) || !isLetter(text, at + 1)))
    {
      result += "\\-";
    }
    else
    {
      result += text[at];
    }
  }
  return result;
}

/// Returns the name of an option or a command for roff, where no hyphen is one of prose.
std::string escapedName(const std::string& name)
{
  std::string result;
  for (const char letter : name)
  {
    result += letter == '-' ? std::string("\\-") : std::string(1, letter);
  }
  return result;
}

std::string bold(const std::string& name)
{
  return "\\fB" + escapedName(name) + "\\fR";
}

std::string italic(const std::string& text)
{
  return text.empty() ? "" : "\\fI" + escapedName(text) + "\\fR";
}

/// Returns prose as lines of roff: sentences begin lines, lines are short, and none is a request.
std::string paragraph(const std::string& text)
{
  constexpr std::size_t columns = 76;
  std::string lines, line;
  const auto end = [&]
  {
    if (!line.empty())
    {
      lines += (line[0] == '.' || line[0] == '\'' ? "\\&" : "") + line + "\n";
      line.clear();
    }
  };
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    const bool isOption = word.find("--") != std::string::npos;
    const std::string printed = isOption ? escapedName(word) : escaped(word);
    if (line.size() + 1 + printed.size() > columns)
    {
      end();
    }
    line += (line.empty() ? "" : " ") + printed;
    if (word.back() == '.' && word.find("...") == std::string::npos)
    {
      end();
    }
  }
  end();
  return lines;
}

/// Returns names as "--a, --b and --c", with `link` between the last two.
std::string joined(const std::vector<std::string>& names, const std::string& link)
{
  std::string text;
  for (std::size_t at = 0; at < names.size(); ++at)
  {
    text += at == 0 ? "" : at + 1 == names.size() ? " " + link + " " : ", ";
    text += names[at];
  }
  return text;
}

/// Returns text with a full stop, unless it ends with one or with a suffix of files.
std::string endedSentence(const std::string& text)
{
  const std::string last = text.substr(text.find_last_of(' ') + 1);
  return last.empty() || last.front() == '.' || last.back() == '.' ? text : text + ".";
}

/// Returns the beginning of what follows a text: a new sentence, or behind a suffix of files, which
/// has no full stop, more of the same one.
std::string next(const std::string& text, std::string beginning)
{
  if (!text.empty() && text.back() != '.')
  {
    beginning[0] = static_cast<char>(beginning[0] - 'A' + 'a');
    return "; " + beginning;
  }
  return " " + beginning;
}

/// Returns an item of a list: an option or an argument with its help.
std::string itemOf(const OptionEntry& option)
{
  std::string names;
  for (const std::string& name : option.names)
  {
    names += (names.empty() ? "" : ", ") + (option.isPositional ? italic(name) : bold(name));
  }
  names += option.isPositional || option.values.empty() ? "" : " " + italic(option.values);
  std::string help = endedSentence(option.help);
  if (option.isRequired && !option.isPositional)
  {
    help = "Required. " + help;
  }
  if (!option.excluded.empty())
  {
    help += next(help, "Not together with ") + joined(option.excluded, "or") + ".";
  }
  if (!option.needed.empty())
  {
    help += next(help, "Needs ") + joined(option.needed, "and") + ".";
  }
  return ".TP\n" + names + "\n" + paragraph(help);
}

std::string header(const std::string& name, const std::string& help, const std::string& date,
  const std::string& version)
{
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(),
    [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  std::string brief = briefHelp(help);
  brief[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(brief[0])));
  return ".TH " + escapedName(title) + " 1 \"" + date + "\" \"winding " + version + "\"\n" +
         ".SH NAME\n" + paragraph(name + " - " + brief);
}

/// Returns the options in their groups, in the order in which groups begin.
std::string optionSections(const std::vector<OptionEntry>& options)
{
  std::vector<std::string> groups;
  for (const OptionEntry& option : options)
  {
    if (!option.isPositional &&
        std::find(groups.begin(), groups.end(), option.group) == groups.end())
    {
      groups.push_back(option.group);
    }
  }
  std::string text = ".SH OPTIONS\n";
  for (const std::string& group : groups)
  {
    text += groups.size() == 1 || group == "Options" ? "" : ".SS " + group + "\n";
    for (const OptionEntry& option : options)
    {
      text += !option.isPositional && option.group == group ? itemOf(option) : "";
    }
  }
  return text;
}

/// Returns a reference to a man page, as ".BR name (1)".
std::string reference(const std::string& name, const std::string& behind)
{
  return ".BR " + escapedName(name) + " (1)" + behind + "\n";
}

std::string exitStatusItem(ExitStatus status, const std::string& meaning)
{
  return ".TP\n" + std::to_string(status) + "\n" + paragraph(meaning);
}

/// Returns the section of exit statuses, which are the same for all commands.
std::string exitStatuses()
{
  return ".SH EXIT STATUS\n" + exitStatusItem(EXIT_DONE, "All is done.") +
         exitStatusItem(EXIT_USAGE, "The command line makes no sense.") +
         exitStatusItem(EXIT_REFUSED, "A file cannot be read, worked with or written.") +
         exitStatusItem(EXIT_NO_MEMORY, "The result does not fit into memory.") +
         exitStatusItem(EXIT_INTERRUPTED, "The program was interrupted.");
}

} // namespace

std::string manPageOfProgram(
  const CommandEntry& program, const std::string& date, const std::string& version)
{
  std::string page = header(program.name, program.help, date, version);
  page += ".SH SYNOPSIS\n.B winding\n.I command\n.RI [ option ...]\n.I file ...\n";
  page += ".SH DESCRIPTION\n" + paragraph(endedSentence(program.help)) +
          paragraph("Each command has a page of its own.");
  page += ".SH COMMANDS\n";
  for (const CommandEntry& command : program.commands)
  {
    page += ".TP\n" + bold(command.name) + "\n" + paragraph(endedSentence(command.help)) + "See\n" +
            reference("winding-" + command.name, ".");
  }
  page += optionSections(program.options);
  page += exitStatuses();
  page += ".SH SEE ALSO\n";
  for (const CommandEntry& command : program.commands)
  {
    page += reference(
      "winding-" + command.name, command.name == program.commands.back().name ? "" : " ,");
  }
  return page;
}

std::string manPageOfCommand(
  const CommandEntry& command, const std::string& date, const std::string& version)
{
  const std::string name = "winding-" + command.name;
  std::string page = header(name, command.help, date, version);
  std::string arguments, required;
  for (const OptionEntry& option : command.options)
  {
    if (option.isPositional)
    {
      arguments += (arguments.empty() ? ".SH ARGUMENTS\n" : "") + itemOf(option);
      required += ".I " + option.names[0] + (option.mostValues > 1 ? " ...\n" : "\n");
    }
    else if (option.isRequired)
    {
      required += bold(option.names[0]) + " " + italic(option.values) + "\n";
    }
  }
  page += ".SH SYNOPSIS\n.B winding " + command.name + "\n" + required + ".RI [ option ...]\n";
  page += ".SH DESCRIPTION\n" + paragraph(endedSentence(command.help)) + arguments +
          optionSections(command.options);
  page += exitStatuses() + ".SH SEE ALSO\n" + reference("winding", "");
  return page;
}
