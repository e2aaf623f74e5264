#pragma once

#include <string>

/// The end of a file name that says what is in the file: from its last dot on, in small letters.
/// May be empty.
std::string suffixOf(const std::string& fileName);

/// Whether the suffix says that a file is a table: .csv, with commas, or .tsv, with tabs.
bool isTable(const std::string& fileName);

/// The letter between the fields of a table of that name: a tab in .tsv, a comma otherwise.
char separatorOf(const std::string& fileName);
