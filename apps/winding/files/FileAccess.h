#pragma once

#include <string>

/// The whole of a file as text. Throws Failure when it is missing, unreadable, empty or no regular
/// file; it never waits for a pipe.
std::string contentsOf(const std::string& fileName);

/// The first bytes of a file, all where it has fewer. Throws Failure as contentsOf() does.
std::string beginningOf(const std::string& fileName, std::size_t bytes);
