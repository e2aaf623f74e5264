// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

#include <vector>

namespace winding
{

/// How refusals speak of what is done.
struct ProbeWords
{
  const char* dataSet;          ///< the data set, as a part of a sentence
  std::vector<Remedy> remedies; ///< what to do where memory is short
};

inline const ProbeWords wordsOfProbe = {
  "the data set to be probed", {{"probe a part of the data set", {}}, {"probe fewer samples", {}}}};
inline const ProbeWords wordsOfClip = {
  "the data set to be clipped", {{"clip a part of the data set", {}}, {"clip a coarser one", {}}}};

} // namespace winding
