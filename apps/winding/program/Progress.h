// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <chrono>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkObject;
VTK_ABI_NAMESPACE_END

/// The parts of a run, which have their shares of one bar: reading 30 %, preparing 10 % and more
/// where it shows progress, and of each of the pieces that share the rest, evaluating 90 %.
enum class Phase
{
  reading,
  evaluating, ///< preparing first, as long as the algorithm's progress text is "Preparing"
  writing
};

/**
 * Follows an algorithm while this object lives: shows a bar of the whole run on standard error when
 * that is a terminal, unless quiet, and aborts the algorithm when the program is
 * interrupted. The bar never goes back.
 */
class Progress
{
public:
  /// `word` says what the algorithm does; by default that is the phase.
  Progress(vtkAlgorithm* algorithm, Phase phase, bool quiet, const char* word = nullptr);
  ~Progress();
  Progress(const Progress&) = delete;
  void operator=(const Progress&) = delete;

  /// Says that evaluating and writing take turns, `pieces` times.
  static void setPieces(int pieces);

  /// Takes the bar away from the terminal, if one stands there.
  static void clear();

private:
  void begin(vtkObject*, unsigned long, void*);
  void follow(vtkObject*, unsigned long, void*);
  void draw();

  vtkAlgorithm* algorithm_;
  Phase phase_;
  const char* word_;
  unsigned long startObserver_;
  unsigned long observer_;
  bool visible_;
  std::chrono::steady_clock::time_point drawn_;
};
