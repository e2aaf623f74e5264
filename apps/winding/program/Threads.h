#pragma once

#include <cstddef>
#include <functional>

/// Limits vtkSMPTools to so many threads, as far as the machine has them; 0 changes nothing.
void limitThreads(int threads);

/// How many threads filters use after limitThreads() of the same number.
int threadsUsed(int threads);

/// Calls work(0) … work(count − 1) on the threads of vtkSMPTools. Work may throw: of what is thrown,
/// that of the lowest number comes out, for any number of threads. Throws Failure if a signal has
/// come.
void runOnThreads(std::size_t count, const std::function<void(std::size_t)>& work);
