// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pages.h"

namespace
{

std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : separator) + word;
  }
  return text;
}

/// Returns text with a backslash before each of these letters.
std::string escaped(const std::string& text, const std::string& letters)
{
  std::string result;
  for (const char letter : text)
  {
    result += (letters.find(letter) == std::string::npos ? "" : "\\") + std::string(1, letter);
  }
  return result;
}

/// Returns text in single quotes, with apostrophes as bash and zsh take them.
std::string quoted(const std::string& text)
{
  std::string result = "'";
  for (const char letter : text)
  {
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return result + "'";
}

std::string quotedForFish(const std::string& text)
{
  return "'" + escaped(text, "\\'") + "'";
}

/// Returns the names of a command's options.
std::vector<std::string> optionNames(const CommandEntry& command)
{
  std::vector<std::string> names;
  for (const OptionEntry& option : command.options)
  {
    if (!option.isPositional)
    {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
  }
  return names;
}

/// Returns an expression for the suffixes of an option's files, as "vtp|ply|nii[.]gz".
std::string suffixExpression(const OptionEntry& option)
{
  std::string expression;
  for (const char letter : joined(option.suffixes, "|"))
  {
    expression += letter == '.' ? std::string("[.]") : std::string(1, letter);
  }
  return expression.empty() ? "[^.]*" : expression;
}

const std::string origin = "made from the program's own list of options.\n";

/// Returns what bash does for the value of one option.
std::string bashValue(const OptionEntry& option)
{
  if (option.isFile)
  {
    return "_winding_files \"$word\" " + quoted(suffixExpression(option));
  }
  return option.choices.empty() ? "COMPREPLY=()" : "words=" + quoted(joined(option.choices, " "));
}

std::string bashCommand(const CommandEntry& command)
{
  std::string text = "    " + command.name + ")\n      case $before in\n", others;
  for (const OptionEntry& option : command.options)
  {
    if (!option.isPositional && option.mostValues > 0)
    {
      text += "        " + joined(option.names, " | ") + ") " + bashValue(option) + " ;;\n";
    }
    else if (option.isPositional)
    {
      others = bashValue(option);
    }
  }
  return text + "        *)\n          if [[ $word == -* ]]; then\n            words=" +
         quoted(joined(optionNames(command), " ")) + "\n          else\n            " + others +
         "\n          fi\n          ;;\n      esac\n      ;;\n";
}

/// Returns a specification for zsh's _arguments: names, help, and what the values are.
std::string zshArgument(const OptionEntry& option)
{
  const std::string help = "[" + escaped(briefHelp(option.help), "[]:\\") + "]";
  std::string values;
  if (option.mostValues > 0)
  {
    const std::string name = option.isPositional ? option.names[0] : option.values;
    std::string action = " ";
    if (option.isFile)
    {
      action = option.suffixes.empty()
                 ? "_files"
                 : "_files -g \"(#i)*.(" + joined(option.suffixes, "|") + ")(|.gz)(-.)\"";
    }
    else if (!option.choices.empty())
    {
      action = "(" + joined(option.choices, " ") + ")";
    }
    values = ":" + escaped(name, ":\\") + ":" + action;
  }
  if (option.isPositional)
  {
    return quoted((option.mostValues > 1 ? "*" : "") + values);
  }
  std::vector<std::string> excluded = option.excluded;
  excluded.insert(excluded.end(), option.names.begin(), option.names.end());
  const std::string exclusions = quoted("(" + joined(excluded, " ") + ")");
  std::string text;
  for (const std::string& name : option.names)
  {
    std::string specification = name;
    if (option.mostValues > 0)
    {
      specification += name[1] == '-' ? "=" : "+";
    }
    specification += help + values;
    text += text.empty() ? "" : " \\\n        ";
    text += exclusions + quoted(specification);
  }
  return text;
}

std::string zshCommand(const CommandEntry& command)
{
  std::string text = "    " + command.name + ")\n      _arguments -S";
  for (const OptionEntry& option : command.options)
  {
    text += " \\\n        " + zshArgument(option);
  }
  return text + "\n      ;;\n";
}

/// Returns fish's line for an option of the program, or of a command.
std::string fishOption(const OptionEntry& option, const std::string& condition)
{
  std::string text = "complete -c winding -n " + quotedForFish(condition);
  for (const std::string& name : option.names)
  {
    if (!option.isPositional)
    {
      text += name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
  }
  if (option.isFile)
  {
    text += (option.isPositional ? " -f -a " : " -x -a ") +
            quotedForFish("(__winding_files " + quotedForFish(suffixExpression(option)) + ")");
  }
  else if (option.mostValues > 0)
  {
    text +=
      " -x" + (option.choices.empty() ? "" : " -a " + quotedForFish(joined(option.choices, " ")));
  }
  return text + (option.isPositional ? "" : " -d " + quotedForFish(briefHelp(option.help))) + "\n";
}

} // namespace

std::string completionsForBash(const CommandEntry& program)
{
  std::string text = "# Completions of winding for bash, " + origin +
                     R"(
# _winding_files <word> <suffixes>: offers folders, and files with one of the suffixes, packed by
# gzip or not; without any, all files.
_winding_files() {
  local name
  compopt -o filenames 2>/dev/null
  while IFS= read -r name; do
    if [[ -d ${name/#\~\//$HOME/} || ${name,,} =~ \.($2)(\.gz)?$ ]]; then
      COMPREPLY+=("$name")
    fi
  done < <(compgen -f -- "$1")
  [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default 2>/dev/null
}

_winding() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= words= name
  COMPREPLY=()
  # The value of --option=value is a word behind "=", which is one, too.
  if [[ $word == '=' ]]; then
    word=
  elif [[ $before == '=' ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  [[ $COMP_CWORD -lt 2 ]] || command=${COMP_WORDS[1]}
  case $command in
)";
  std::vector<std::string> first;
  for (const CommandEntry& command : program.commands)
  {
    text += bashCommand(command);
    first.push_back(command.name);
  }
  for (const std::string& name : optionNames(program))
  {
    first.push_back(name);
  }
  return text + "    '') words=" + quoted(joined(first, " ")) +
         R"( ;;
  esac
  while IFS= read -r name; do
    COMPREPLY+=("$name")
  done < <(compgen -W "$words" -- "$word")
}

complete -F _winding winding
)";
}

std::string completionsForZsh(const CommandEntry& program)
{
  std::string text = "#compdef winding\n# Completions of winding for zsh, " + origin +
                     R"(
_winding_commands() {
  local -a commands=(
)";
  for (const CommandEntry& command : program.commands)
  {
    text += "    " + quoted(command.name + ":" + escaped(briefHelp(command.help), ":\\")) + "\n";
  }
  text += R"(  )
  _describe command commands
}

_winding() {
  local curcontext=$curcontext state state_descr line
  typeset -A opt_args
  _arguments -C)";
  for (const OptionEntry& option : program.options)
  {
    text += " \\\n    " + zshArgument(option);
  }
  text += R"( \
    '1:command:_winding_commands' '*::argument:->arguments' && return
  [[ $state == arguments ]] || return
  case $words[1] in
)";
  for (const CommandEntry& command : program.commands)
  {
    text += zshCommand(command);
  }
  return text + R"(  esac
}

_winding "$@"
)";
}

std::string completionsForFish(const CommandEntry& program)
{
  std::string text = "# Completions of winding for fish, " + origin +
                     R"fish(
# Offers folders, and files with one of the suffixes, packed by gzip or not; without any, all files.
function __winding_files --argument-names suffixes
    set -l files (__fish_complete_path (string replace -r '^--[^=]*=' '' -- (commandline -ct)))
    string match -ier "^[^\t]*(/|\.($suffixes)(\.gz)?)(\t|\$)" -- $files
    or printf '%s\n' $files
end

complete -c winding -f
)fish";
  for (const OptionEntry& option : program.options)
  {
    text += fishOption(option, "__fish_use_subcommand");
  }
  for (const CommandEntry& command : program.commands)
  {
    text += "complete -c winding -n __fish_use_subcommand -a " + command.name + " -d " +
            quotedForFish(briefHelp(command.help)) + "\n";
    for (const OptionEntry& option : command.options)
    {
      text += fishOption(option, "__fish_seen_subcommand_from " + command.name);
    }
  }
  return text;
}
