#pragma once

#include <cstddef>
#include <functional>

/// Limits vtkSMPTools to so many threads, as far as the machine has them; 0 changes nothing.
void limitThreads(int threads);

/// How many threads filters use after limitThreads() of the same number.
int threadsUsed(int threads);

/// Calls work(0) … work(count − 1) on the threads of vtkSMPTools. Work may throw: what the lowest
/// number throws comes out, for any number of threads, and numbers above it may be left undone.
/// Throws Failure if a signal has come.
void runOnThreads(std::size_t count, const std::function<void(std::size_t)>& work);
