// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>

/// A JSON value whose objects keep the order in which names are put in.
using Json = nlohmann::ordered_json;

/// Prints text or JSON on standard output, with the end of a line. Throws Failure where that is not
/// possible.
void print(const std::string& text);
void print(const Json& object);

/// Throws Failure where standard output has not taken all that went there.
void requirePrinted();

/// Returns a number as people read it, with `digits` significant digits at most.
std::string shown(double value, int digits = 6);
