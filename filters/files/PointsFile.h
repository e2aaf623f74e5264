// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/ColumnNames.h"
#include "files/InputFile.h"
#include "files/MeshArrays.h"

namespace winding
{

/**
 * Reads points from text (.xyz, .pwn): one point on a line, as `x y z` or `x y z nx ny nz`, the
 * same on all lines, with comments from '#' on. The first line may be the number of points; the
 * normals may then also stand in lines of their own after all positions. All points are in one
 * vertex cell.
 *
 * Numbers may stand between blanks, commas or semicolons, and have decimal commas where blanks or
 * semicolons stand between them. Names in a line before all others, behind "//" or not, say what
 * the columns are (ColumnNames.h), areas too, however many there are. Without names, three columns
 * behind the position are its normal, unless they are colours: none is negative, they are whole
 * numbers up to 65535, or up to 1, and most are no unit vectors. A note then says so.
 *
 * Throws FileRefusal for all else, and Interrupted. The result is the same for any number of
 * threads.
 */
MeshArrays readPoints(const InputFile& file, Executor& executor);

/// Reads points as readPoints() does, from the columns that a user has chosen. Lines need no names
/// where these are numbers. Reads other columns where they have names, or some were chosen.
MeshArrays readPointColumns(const InputFile& file, const ColumnWishes& wishes, Executor& executor);

} // namespace winding
