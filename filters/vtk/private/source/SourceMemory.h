// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace winding
{

class InputViews;
class Ranks;

/// The memory that work on a source takes in addition to the source itself, in bytes.
struct BytesOfWork
{
  double perCell;  ///< of a mesh
  double perPoint; ///< of a cloud, or of a mesh that is taken as one
};

///@{
/// Measured with 1.28 million triangles and with 640 000 points: building a field, a report, and
/// areas.
constexpr BytesOfWork bytesOfField = {80, 250};
constexpr BytesOfWork bytesOfReport = {130, 330};
constexpr BytesOfWork bytesOfAreas = {250, 250};
///@}

/// The memory of work on a cloud for which consistent normals may be found, too (measured with a
/// million points).
inline BytesOfWork withNormals(const BytesOfWork& bytes, bool areFound)
{
  constexpr double perPoint = 350;
  return {bytes.perCell, areFound && bytes.perPoint < perPoint ? perPoint : bytes.perPoint};
}

/// The memory of work on a source that is seen in the coordinates of an image (FramedViews.h), too:
/// of a point and three ids for each cell, or of a point and its normal.
inline BytesOfWork withFramedViews(const BytesOfWork& bytes)
{
  return {bytes.perCell + 48, bytes.perPoint + 48};
}

/// The memory of work on a source that is there `copies` times, as its mirror images make it.
inline BytesOfWork withImages(const BytesOfWork& bytes, std::size_t copies)
{
  return {copies * bytes.perCell, copies * bytes.perPoint};
}

/// Throws OutOfMemory where the work on the source of all ranks, which they have compared, does not
/// fit into free memory, before anything is allocated. `what` names the work, as in "the report".
/// Where the first rank works alone, the others need no memory. Collective.
void refuseHugeSource(const InputViews& source, const BytesOfWork& bytes, const char* what,
  Ranks& ranks, bool onlyOnFirst = false);

} // namespace winding
