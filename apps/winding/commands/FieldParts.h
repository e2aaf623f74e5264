// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

/// The extent of points of an image, as VTK counts them.
using SlabExtent = std::array<int, 6>;

/// Cuts the grid into slabs along z, at most `slabs`; no slab is empty. Slabs of samples that are
/// points share a layer with the next one where `overlap` is wanted, as the pieces of VTK's images
/// do, and otherwise have none in common. Cells are never shared.
std::vector<SlabExtent> slabsOf(
  const int (&samples)[3], bool asCells, bool overlap, std::size_t slabs);

/// Returns the image of a whole grid on the first rank, put together of slabs without a layer in
/// common: the n-th is the image of rank n, whose own is null where there are fewer slabs. The
/// other ranks get null. Throws Failure where the whole does not fit into memory. Collective.
vtkSmartPointer<vtkImageData> gatheredImage(
  vtkImageData* own, const std::vector<SlabExtent>& slabs);
