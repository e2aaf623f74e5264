// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/**
 * Returns the files that an index names as its parts (.vtm .pvtp .pvtu .gltf), and their own, where
 * these are indices; none for other files. Throws Failure for a part of VTK's formats that is not
 * there: VTK's readers pass over some of them in silence.
 */
std::vector<std::string> pieceFilesOf(const std::string& fileName);
