#pragma once

#include <string>

/// A number with 17 significant digits, with which every double comes back with the same bits.
std::string exact(double value);
