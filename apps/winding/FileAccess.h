#pragma once

#include <string>
#include <string_view>

/// The whole of a file as text. Throws Failure when it is missing, a folder, unreadable or empty.
std::string contentsOf(const std::string& fileName);

/// As contentsOf, but the first bytes only.
std::string beginningOf(const std::string& fileName, std::size_t bytes);

/**
 * Throws Failure where the first bytes say that the file is not what its suffix says. VTK's readers
 * believe the suffix, and some of them give an empty surface for anything.
 */
void checkContentFits(const std::string& fileName);

/// The next line from `start` on, without its end; moves `start` behind it.
std::string_view takeLine(std::string_view text, std::size_t& start);

/// The next word, ended by white space; empty when there is none left.
std::string_view takeWord(std::string_view& text);

/// A word that is a whole number; false if it is none, or more than fits.
bool parseInteger(std::string_view word, long long& value);

/// A word that is a number in any of the ways that text files have them, nan and inf too.
bool parseNumber(std::string_view word, double& value);
