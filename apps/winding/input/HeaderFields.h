// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/**
 * @file
 * Headers of images as text: fields with keys and numbers. All functions throw HeaderFault.
 */

/// The fields of a header by their keys.
using HeaderFields = std::map<std::string, std::string>;

/// Takes the next line off a header. Throws behind the last one: the file has another kind of data,
/// or is cut off.
std::string_view takeHeaderLine(const std::string& head, std::size_t& start);

/// Returns the first of some fields that is there; null if none is.
const std::string* findAny(const HeaderFields& fields, const std::vector<const char*>& keys);

/// Reads the finite number that a word is; `key` names its field.
double numberOf(std::string_view word, const std::string& key);

/// Reads the `count` numbers of a field.
std::vector<double> numbersOf(std::string_view text, const std::string& key, std::size_t count);

/// Throws for a field that has another number of numbers than `wanted`.
void checkCount(std::size_t found, const std::string& key, std::size_t wanted);

/// Returns a number of voxels, from 1 on.
int sizeOf(double value, const std::string& key);

/// Returns the number of axes that a field says. Three at most are of space.
std::size_t axesOf(const HeaderFields& fields, const char* key);

/// Refuses an axis of space that goes along time as well.
void checkStep(const std::vector<double>& step);
