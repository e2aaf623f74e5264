// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

/**
 * @file
 * Files as text: how they are read and taken apart, and how numbers are written.
 */

/// The fault of a name that leads to no regular file.
constexpr const char* specialFile = "is a pipe, a device or a socket; give a regular file";

/// Returns the whole of a file as text. Throws Failure when it is missing, unreadable, empty, text
/// in UTF-16 or no regular file; it never waits for a pipe.
std::string contentsOf(const std::string& fileName);

/// Returns the first bytes of a file, all where it has fewer. Throws Failure as contentsOf() does.
std::string beginningOf(const std::string& fileName, std::size_t bytes);

/// Returns the next line from `start` on, without its end, which is LF, CR or both; moves `start`
/// behind it.
std::string_view takeLine(std::string_view text, std::size_t& start);

/// Returns the next word, ended by white space, and takes it off the text; empty when there is none
/// left.
std::string_view takeWord(std::string_view& text);

/// Takes blanks off both ends of a text.
std::string_view trimmed(std::string_view text);

/// Returns whether a text begins in this way.
bool startsWith(std::string_view text, std::string_view start);

/// Returns whether a text ends in this way.
bool endsWith(std::string_view text, std::string_view end);

/// Reads a word that is a whole number. False if it is none, or does not fit into the value.
bool parseInteger(std::string_view word, long long& value);

/// Reads a word that is a number, the same in every locale. False if it is none, or beyond the
/// largest double. Numbers below the smallest one are 0.
bool parseNumber(std::string_view word, double& value);

/// Returns a text with small letters for capital ones, as far as ASCII has them.
std::string inSmallLetters(std::string_view text);

/// Returns a name with the letters that percent codes of an URI stand for.
std::string withoutPercentCodes(const std::string& name);

/// Returns the shortest number with which a double comes back with the same bits.
std::string exact(double value);

/// Returns the three numbers of a vector, with a separator between them.
std::string exact(const double vector[3], char separator);

/// Appends exact(value) to a text.
void appendExact(std::string& text, double value);

/// Returns a text as a field of a table: in quotation marks where readers would take it apart or
/// trim it otherwise.
std::string asField(const std::string& text, char separator);
