// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Digits.h"
#include "base/Parameter.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace winding
{

/// A parameter, and the value that it should have if a message proposes one: 1 for on, 0 for off,
/// or the number of a choice.
struct Setting
{
  Parameter parameter;
  std::optional<int> value;

  Setting(Parameter which) // NOLINT(google-explicit-constructor): messages list parameters
    : parameter(which)
  {
  }

  Setting(Parameter which, int proposed)
    : parameter(which)
    , value(proposed)
  {
  }
};

/// A way out for the user: in words, in settings, or both. A remedy without words is of no use to a
/// front end that has no name for its settings, which leaves it out.
struct Remedy
{
  std::string words;
  std::vector<Setting> settings;
};

/**
 * The fault and what to do about it, without any front end's names. A front end makes one
 * line of it: "`subject` `fault`: `remedies`; `facts`", the subject and the settings by their names
 * there. A user may see no more than the beginning, so that `fault` has eight words at most.
 */
struct Message
{
  std::optional<Parameter> subject; ///< the parameter that the fault is about
  std::string fault;
  std::vector<Remedy> remedies; ///< alternatives, the easiest first
  std::string facts;            ///< numbers and reasons; may be empty

  Message() = default;

  /// Makes a message without names.
  Message(std::string what) // NOLINT(google-explicit-constructor): a sentence is a message
    : fault(std::move(what))
  {
  }

  Message(std::string what, std::vector<Remedy> ways, std::string why = "")
    : fault(std::move(what))
    , remedies(std::move(ways))
    , facts(std::move(why))
  {
  }

  /// Makes a message about a parameter: `what` is a predicate, such as "is -1".
  Message(Parameter about, std::string what)
    : subject(about)
    , fault(std::move(what))
  {
  }
};

/// Returns a share, 0 to 1, as a percentage of two digits.
inline std::string percentOf(double share)
{
  return (share < 0.095 ? inDigits(100 * share, 2) : inPlaces(100 * share, 0)) + " %";
}

/// Returns the remedy for voxels that are too many or too small.
inline Remedy largerVoxels()
{
  return {"choose larger voxels", {Parameter::resolution, Parameter::voxelSize}};
}

/// Returns the remedy for voxels that are too few or too large.
inline Remedy smallerVoxels()
{
  return {"choose smaller voxels", {Parameter::resolution, Parameter::voxelSize}};
}

/// Returns the remedy for solids that are thinner than a voxel.
inline Remedy touchedVoxels()
{
  constexpr int any = 1; // as Coverage::any
  return {"take voxels that it touches", {{Parameter::coverage, any}}};
}

/// Returns the remedy for results that are too large as a whole.
inline Remedy inPieces()
{
  return {"", {Parameter::pieces}};
}

/// Returns the sentence of a message without names, for those that name its parameters themselves.
inline std::string sentenceOf(const Message& message)
{
  std::string text = message.fault;
  const char* before = ": ";
  for (const Remedy& remedy : message.remedies)
  {
    if (!remedy.words.empty())
    {
      text += before + remedy.words;
      before = ", or ";
    }
  }
  return message.facts.empty() ? text : text + "; " + message.facts;
}

} // namespace winding
