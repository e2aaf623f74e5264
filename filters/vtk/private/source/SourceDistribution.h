// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "private/source/GatheredViews.h"

#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// The ways in which ranks may hold a source; the numbers are the property's
/// SourceDistribution.
enum class SourceDistribution
{
  automatic,   ///< in parts, unless all ranks have the same data
  distributed, ///< in parts, whatever they have
  replicated   ///< as a whole, each of them
};

/// The distribution that has this number as a property. Throws Refusal.
SourceDistribution sourceDistribution(int number);

/// Asks upstream for the part of a source that a rank is to have.
void requestPart(vtkInformation* source, const Ranks& ranks, SourceDistribution distribution);

} // namespace winding
