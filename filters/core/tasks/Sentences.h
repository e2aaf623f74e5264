// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

#include <string>
#include <vector>

namespace winding
{

/// The sentences of front ends, which Sentences.def lists.
enum class Sentence
{
#define SENTENCE(name, ...) name,
#include "tasks/Sentences.def"
#undef SENTENCE
};

/// Returns a message with the values of a case in place of {0}, {1} …
Message messageOf(Sentence sentence, const std::vector<std::string>& values = {});

/// Returns the same by the sentence's name. Throws std::out_of_range where there is none.
Message messageOf(const std::string& sentence, const std::vector<std::string>& values);

} // namespace winding
