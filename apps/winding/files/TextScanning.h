#pragma once

#include <string>
#include <string_view>

/// The next line from `start` on, without its end; moves `start` behind it.
std::string_view takeLine(std::string_view text, std::size_t& start);

/// The next word, ended by white space, which is taken off the text; empty when there is none left.
std::string_view takeWord(std::string_view& text);

/// Reads a word that is a whole number. False if it is none, or does not fit into the value.
bool parseInteger(std::string_view word, long long& value);

/// A text with small letters for capital ones, of those that ASCII has.
std::string inSmallLetters(std::string_view text);
