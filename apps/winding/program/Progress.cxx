// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/Progress.h"

#include "program/Interrupt.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include <unistd.h>

namespace
{

using Clock = std::chrono::steady_clock;

constexpr double afterReading = 0.3;
constexpr double afterPreparing = 0.4;
constexpr double ofEvaluating = 0.9; ///< of each piece, the rest is writing

/// The bar of the run.
struct Bar
{
  Clock::time_point start = Clock::now();
  bool stands = false;
  double shown = 0;
  int pieces = 1;
  int begun = 0; ///< pieces whose evaluation has begun
};

Bar bar;

bool isPreparing(vtkAlgorithm* algorithm)
{
  const char* const text = algorithm->GetProgressText();
  return text && std::strcmp(text, "Preparing") == 0;
}

/// How far the run is when a part has come to a fraction.
double wholeFraction(Phase phase, bool preparing, double fraction)
{
  if (phase == Phase::reading)
  {
    return afterReading * fraction;
  }
  if (preparing)
  {
    // Where preparing shows progress, it shares that with the evaluation of the first piece.
    const double afterPiece = afterPreparing + (1 - afterPreparing) * ofEvaluating / bar.pieces;
    return afterReading + (afterPiece - afterReading) * fraction;
  }
  const int piece = std::clamp(bar.begun - 1, 0, bar.pieces - 1);
  const double ofPiece =
    phase == Phase::evaluating
      ? ofEvaluating * fraction
      // The progress of a writer covers all pieces.
      : ofEvaluating + (1 - ofEvaluating) * std::clamp(fraction * bar.pieces - piece, 0.0, 1.0);
  return afterPreparing + (1 - afterPreparing) * (piece + ofPiece) / bar.pieces;
}

} // namespace

Progress::Progress(vtkAlgorithm* algorithm, Phase phase, bool quiet, const char* word)
  : algorithm_(algorithm)
  , phase_(phase)
  , word_(word                         ? word
          : phase == Phase::reading    ? "reading"
          : phase == Phase::evaluating ? "evaluating"
                                       : "writing")
  , visible_(!quiet && isatty(STDERR_FILENO))
  , drawn_(Clock::now()) // work of a moment needs no bar
{
  startObserver_ = algorithm->AddObserver(vtkCommand::StartEvent, this, &Progress::begin);
  observer_ = algorithm->AddObserver(vtkCommand::ProgressEvent, this, &Progress::follow);
}

Progress::~Progress()
{
  algorithm_->RemoveObserver(startObserver_);
  algorithm_->RemoveObserver(observer_);
  clear();
}

void Progress::setPieces(int pieces)
{
  bar.pieces = std::max(1, pieces);
}

void Progress::clear()
{
  if (bar.stands)
  {
    std::fputs("\r\033[K", stderr);
    bar.stands = false;
  }
}

void Progress::begin(vtkObject*, unsigned long, void*)
{
  bar.begun += phase_ == Phase::evaluating ? 1 : 0;
}

void Progress::follow(vtkObject*, unsigned long, void*)
{
  if (interrupt::requested())
  {
    algorithm_->SetAbortExecute(1);
  }
  const auto now = Clock::now();
  if (visible_ && now - drawn_ > std::chrono::milliseconds(100))
  {
    drawn_ = now;
    this->draw();
  }
}

void Progress::draw()
{
  constexpr int width = 40;
  const bool preparing = phase_ == Phase::evaluating && isPreparing(algorithm_);
  const double fraction =
    wholeFraction(phase_, preparing, std::clamp(algorithm_->GetProgress(), 0.0, 1.0));
  bar.shown = std::clamp(fraction, bar.shown, 1.0);
  const auto full = static_cast<std::size_t>(bar.shown * width);
  const std::string filled = std::string(full, '#') + std::string(width - full, '.');
  std::fprintf(stderr, "\r%-10s [%s] %3d %%", preparing ? "preparing" : word_, filled.c_str(),
    static_cast<int>(100 * bar.shown));
  const double seconds = std::chrono::duration<double>(drawn_ - bar.start).count();
  if (seconds >= 2)
  {
    std::fprintf(
      stderr, "  %ld s", std::lround(seconds)); // which goes on where the bar stands still
  }
  bar.stands = true;
}
