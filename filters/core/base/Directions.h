// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace winding
{

/// Returns the numbers in a text, with blanks or commas between them; none where there is anything
/// else, or a number is not finite.
std::vector<double> numbersIn(std::string text);

/// Returns the unit vector that a text stands for: up, down, +x, -x, +y, -y, +z, -z or "direction x
/// y z". It is 0 for other texts.
Eigen::Vector3d directionIn(const std::string& text);

/// Returns the unit vector of a vector; 0 where that has no direction.
Eigen::Vector3d unitOrZero(const Eigen::Vector3d& vector);

/// Returns the text without the blanks around it.
std::string trimmed(const std::string& text);

/// Returns three numbers as a text that numbersIn() reads back to the bit.
std::string textOf(const Eigen::Vector3d& vector);

} // namespace winding
