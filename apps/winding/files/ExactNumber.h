#pragma once

#include <string>

/// The shortest number with which a double comes back with the same bits.
std::string exact(double value);

/// The three numbers of a vector, with a separator between them.
std::string exact(const double vector[3], char separator);

/// Appends exact(value) to a text.
void appendExact(std::string& text, double value);
