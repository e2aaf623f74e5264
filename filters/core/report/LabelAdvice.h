// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/InsideRule.h"
#include "base/Message.h"
#include "diagnosis/ThinParts.h"
#include "field/Field.h"
#include "report/LabelFacts.h"
#include "source/Grid.h"

#include <cstddef>
#include <string>
#include <vector>

namespace winding
{

/// The samples of labels, and what makes one inside.
struct LabelSampling
{
  Grid grid;
  InsideRule rule;
  double threshold;
  bool mayTouch; ///< whether voxels that a solid touches could count
};

/// Counts a solid in `facts` if parts of it are lost between samples. `hasLabel` says whether a
/// sample has a label of any solid. Throws Interrupted.
void countThinParts(const Field& field, const IsSampleInside& hasLabel,
  const LabelSampling& sampling, const std::string& name, Executor& executor, LabelFacts& facts);

/// Returns the warnings of `count` solids without a label, as a whole or in part, in the order in
/// which they are to be given.
std::vector<Message> labelAdvice(
  const LabelFacts& facts, std::size_t count, const LabelSampling& sampling);

} // namespace winding
