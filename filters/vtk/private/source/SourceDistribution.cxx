// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/SourceDistribution.h"

#include "messages/PropertyChecks.h"
#include "private/source/SourceParts.h"

namespace winding
{

SourceDistribution sourceDistribution(int number)
{
  checkProperty(Parameter::sourceDistribution, number);
  return static_cast<SourceDistribution>(number);
}

void requestPart(vtkInformation* source, const Ranks& ranks, SourceDistribution distribution)
{
  const bool isWhole = distribution == SourceDistribution::replicated;
  requestPiece(source, isWhole ? 0 : ranks.rank(), isWhole ? 1 : ranks.count());
}

} // namespace winding
