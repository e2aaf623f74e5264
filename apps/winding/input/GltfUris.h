// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/**
 * Returns the URIs of buffers and images in a file of glTF, text or binary, except data in the
 * text. The file is read by blocks, and nothing else of it is kept. Files that do not begin with an
 * object of JSON have none, and what follows an error, or 1000 nested brackets, is not looked at.
 */
std::vector<std::string> urisInGltf(const std::string& fileName);
