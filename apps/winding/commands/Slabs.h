#pragma once

#include <array>
#include <cstddef>
#include <vector>

/// The extent of points of an image, as VTK counts them.
using SlabExtent = std::array<int, 6>;

/// Cuts the grid into slabs along z, at most `slabs`; no slab is empty. Slabs of samples that are
/// points share a layer with the next one where `overlap` is wanted, as the pieces of VTK's images
/// do, and otherwise have none in common. Cells are never shared.
std::vector<SlabExtent> slabsOf(
  const int (&samples)[3], bool asCells, bool overlap, std::size_t slabs);
