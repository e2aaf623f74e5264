#pragma once

#include <nlohmann/json.hpp>

#include <chrono>
#include <string>

struct Options;
class vtkWindingNumberAlgorithm;

/// Keeps the order in which names are put in.
using Json = nlohmann::ordered_json;

/// Seconds since it was made, or since the last lap.
class Stopwatch
{
public:
  double total() const { return seconds(start_); }
  double lap()
  {
    const double result = seconds(lap_);
    lap_ = Clock::now();
    return result;
  }

private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::time_point from)
  {
    return std::chrono::duration<double>(Clock::now() - from).count();
  }

  Clock::time_point start_ = Clock::now();
  Clock::time_point lap_ = start_;
};

/// About the source of an executed filter.
Json describeInput(const std::string& fileName, const vtkWindingNumberAlgorithm& filter);

/// Most memory that the program has held so far, in bytes.
long long peakMemory();

/// The threads that filters may use.
int threadsOf(const Options& options);

/// Prints on standard output; throws Failure where that is not possible.
void print(const std::string& text);
void print(const Json& object);

/// A number as people read it.
std::string shown(double value, int digits = 6);
