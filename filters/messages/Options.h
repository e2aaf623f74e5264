// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

#include <string>
#include <vector>

/**
 * @file
 * The options of all filters, as Options.def lists them, and the words of messages in each
 * front end.
 */
namespace winding
{

/// The ways in which people use the filters.
enum class FrontEnd
{
  cxx,
  paraview,
  program,
  python,
  c
};

enum class OptionKind
{
  flag,
  integer,
  number,
  choice,
  text,
  integers,
  numbers
};

/// A value of an option that is a choice.
struct Choice
{
  int number;
  const char* constant; ///< in C++
  const char* entry;    ///< in ParaView
  const char* word;     ///< in the program and in Python
  std::string setter;   ///< in names of setters in C++, as in SetMethodToRows()
};

/// An entry of the list. A name is empty where a front end has none.
struct Option
{
  Parameter parameter;
  const char* property;
  OptionKind kind;
  const char* standard; ///< the default, as PrintSelf() prints it
  double lowest, highest;
  std::string label;
  bool isBehindGear; ///< whether ParaView's panels show it among the advanced properties alone
  const char* option;
  const char* keyword;
  std::vector<Choice> choices;
};

/// Returns the option, or nullptr for what messages name besides options.
const Option* optionOf(Parameter parameter);

/// Returns the name that setters give choice `number`, as SpanningTree in
/// SetNormalEstimationToSpanningTree(), or Unknown where the option has no choice of this number.
const char* nameOfChoice(Parameter parameter, int number);

/// Returns what a front end calls a parameter, or "" where it does not have it.
std::string nameOf(Parameter parameter, FrontEnd frontEnd);

/// Returns what a user of a front end writes or chooses to make a setting, or "" where he cannot.
std::string howTo(const Setting& setting, FrontEnd frontEnd);

/// Returns the line of a message in the words of a front end.
std::string lineOf(const Message& message, FrontEnd frontEnd);

/// Has this thread speak to a front end while it lives.
class FrontEndScope
{
public:
  explicit FrontEndScope(FrontEnd frontEnd);
  ~FrontEndScope();
  FrontEndScope(const FrontEndScope&) = delete;
  FrontEndScope& operator=(const FrontEndScope&) = delete;

private:
  FrontEnd before_;
};

/// Returns the front end that this thread speaks to: C++ outside of every scope.
FrontEnd frontEnd();

/// Returns whether users ask for estimated normals themselves. ParaView's panels begin with them.
bool isEstimateAsked();

/// Returns the line of a message in the words of this thread's front end.
std::string lineOf(const Message& message);

/// Returns the lines of several messages, as one.
std::string lineOf(const std::vector<Message>& messages);

} // namespace winding
