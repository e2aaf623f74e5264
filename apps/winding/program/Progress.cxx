#include "program/Progress.h"

#include "program/Interrupt.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

#include <algorithm>
#include <cstdio>

#include <unistd.h>

namespace
{

bool barStands = false;

} // namespace

Progress::Progress(vtkAlgorithm* algorithm, const std::string& label, bool quiet)
  : algorithm_(algorithm)
  , label_(label)
  , visible_(!quiet && isatty(STDERR_FILENO))
  , drawn_(std::chrono::steady_clock::now()) // work of a moment needs no bar
{
  observer_ = algorithm->AddObserver(vtkCommand::ProgressEvent, this, &Progress::follow);
}

Progress::~Progress()
{
  algorithm_->RemoveObserver(observer_);
  clear();
}

void Progress::clear()
{
  if (barStands)
  {
    std::fputs("\r\033[K", stderr);
    barStands = false;
  }
}

void Progress::follow(vtkObject*, unsigned long, void*)
{
  if (interrupt::requested())
  {
    algorithm_->SetAbortExecute(1);
  }
  const auto now = std::chrono::steady_clock::now();
  if (visible_ && now - drawn_ > std::chrono::milliseconds(100))
  {
    drawn_ = now;
    this->draw(algorithm_->GetProgress());
  }
}

void Progress::draw(double fraction)
{
  constexpr int width = 40;
  const double shown = std::clamp(fraction, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(shown * width);
  const std::string bar = std::string(full, '#') + std::string(width - full, '.');
  std::fprintf(
    stderr, "\r%-8s [%s] %3d %%", label_.c_str(), bar.c_str(), static_cast<int>(100 * shown));
  barStands = true;
}
