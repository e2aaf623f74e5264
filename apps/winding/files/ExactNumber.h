#pragma once

#include <string>

/// The shortest number with which a double comes back with the same bits.
std::string exact(double value);

/// Appends exact(value) to a text.
void appendExact(std::string& text, double value);
