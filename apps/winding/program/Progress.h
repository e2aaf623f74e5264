#pragma once

#include <chrono>
#include <string>

class vtkAlgorithm;
class vtkObject;

/**
 * Follows an algorithm while this object lives: shows a bar on standard error when that is a
 * terminal, unless quiet, and tells the algorithm to abort when the program is interrupted.
 */
class Progress
{
public:
  Progress(vtkAlgorithm* algorithm, const std::string& label, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  void operator=(const Progress&) = delete;

  /// Takes the bar away from the terminal, if one stands there.
  static void clear();

private:
  void follow(vtkObject*, unsigned long, void*);
  void draw(double fraction);

  vtkAlgorithm* algorithm_;
  unsigned long observer_;
  std::string label_;
  bool visible_;
  std::chrono::steady_clock::time_point drawn_;
};
