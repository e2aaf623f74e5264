#pragma once

#include <string>

/**
 * @file
 * VTK's readers crash on some broken files and silently give part of the data for others. Each
 * guard walks through a file as the reader of its format would, and throws a one-line Failure for
 * what the reader would not notice: counts that the file does not hold, truncation, indices out of
 * range.
 */
void guardStl(const std::string& fileName);
void guardPly(const std::string& fileName);
void guardObj(const std::string& fileName);
void guardLegacyVtk(const std::string& fileName);
void guardXmlVtk(const std::string& fileName);
