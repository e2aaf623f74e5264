// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laboratory/FarFieldCosts.h"
#include "laboratory/Triangles.h"

#include "base/Bounds.h"
#include "base/Executor.h"
#include "farfield/FarField.h"
#include "field/Field.h"
#include "source/Surface.h"

#include <memory>

/// Sources with a far field, and two ways to evaluate them: by the field that users have, and by
/// its far field alone.
class FarFieldSubject
{
public:
  virtual ~FarFieldSubject() = default;

  virtual const char* name() const = 0;
  virtual std::size_t sources() const = 0;
  virtual const winding::Bounds& bounds() const = 0;

  virtual std::shared_ptr<const winding::Field> field(
    double tolerance, winding::Executor& executor) const = 0;
  virtual std::shared_ptr<const winding::FarField> farField(
    double tolerance, const winding::Grid& grid, winding::Executor& executor) const = 0;
  virtual ExactCosts exactCosts() const = 0;

  /// Seconds that finding the integer part on a grid takes, on one thread; 0 where there is none.
  virtual double secondsForRows(const winding::Grid&) const { return 0; }
};

/// A mesh as a soup. The subject keeps the references.
std::unique_ptr<FarFieldSubject> soupOf(
  const Triangles& triangles, const winding::Surface& surface);

/// The vertices of a mesh as oriented points, with the areas that the mesh gives them.
std::unique_ptr<FarFieldSubject> cloudOf(const winding::Surface& surface);

/// An open mesh by method rows, whose cap has a far field; null where it has none. The subject
/// keeps the references.
std::unique_ptr<FarFieldSubject> capOf(const Triangles& triangles, const winding::Surface& surface);
