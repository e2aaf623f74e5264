// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ThreadExecutor.h"
#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/InsideRule.h"
#include "base/Message.h"
#include "base/Refusal.h"
#include "base/Views.h"
#include "field/Field.h"
#include "mesh/MeshSkin.h"
#include "messages/Options.h"
#include "source/Grid.h"
#include "tasks/Task.h"
#include "winding.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

/**
 * @file
 * The border between C and the core: structs of any size become the library's, numbers become
 * choices and views, and exceptions become statuses.
 */
namespace winding::c
{

/// Thrown where a call breaks a rule of winding.h.
class Misuse : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Throws Misuse for a null pointer; `name` is the argument's.
template <class T> T& required(T* pointer, const char* name)
{
  if (!pointer)
  {
    throw Misuse(std::string(name) + " is null");
  }
  return *pointer;
}

/// Returns the defaults of a struct, overwritten by as much as the caller has of it.
template <class Struct> Struct known(const Struct* from, Struct defaults)
{
  if (from)
  {
    if (from->size < sizeof(from->size))
    {
      throw Misuse("size of a struct is not set: call its function ending in _init");
    }
    std::memcpy(&defaults, from, std::min<std::size_t>(from->size, sizeof(Struct)));
    defaults.size = sizeof(Struct);
  }
  return defaults;
}

/// Returns an element of a caller's array of structs, which are as large as the first one says.
template <class Struct> const Struct* elementOf(const Struct* array, std::size_t number)
{
  const auto* const bytes = reinterpret_cast<const char*>(array);
  return reinterpret_cast<const Struct*>(bytes + number * array->size);
}

/// Writes as much of a struct as the caller has room for, whose size stays.
template <class Struct> void give(Struct from, Struct& to)
{
  if (to.size < sizeof(to.size))
  {
    throw Misuse("size of a struct is not set: call its function ending in _init");
  }
  from.size = to.size;
  std::memcpy(&to, &from, std::min<std::size_t>(to.size, sizeof(Struct)));
}

/// Fills a struct of the caller's, of `size` bytes, with defaults.
template <class Struct> void fill(Struct* to, std::size_t size, Struct defaults)
{
  if (to && size >= sizeof(to->size))
  {
    defaults.size = static_cast<std::uint32_t>(size);
    std::memset(static_cast<void*>(to), 0, size);
    std::memcpy(to, &defaults, std::min(size, sizeof(Struct)));
  }
}

/// Copies text into a member of a struct, cut off where it is longer.
void copyText(const std::string& text, char* to, std::size_t size);

/// Writes a box as least and largest x, y and z, NaN for an empty one.
void giveBounds(const Bounds& bounds, double (&to)[6]);

///@{
/// The defaults of structs that callers may leave out.
winding_run defaultRun();
winding_options defaultOptions();
winding_rule defaultRule();
///@}

///@{
/// Views of arrays. Throw Misuse for types and sizes that they cannot have; `name` is the
/// argument's. An array of no rows is empty.
VectorsView vectorsOf(const winding_array& array, const char* name);
ScalarsView scalarsOf(const winding_array& array, const char* name);
IdsView idsOf(const winding_array& array, const char* name);
///@}

/// An array of ids of either type.
class Ids
{
public:
  /// Keeps a reference. Throws Misuse as vectorsOf() does, for rows of `width` ids.
  Ids(const winding_array& array, std::int64_t width, const char* name);

  std::size_t rows() const { return static_cast<std::size_t>(array_.rows); }

  std::int64_t operator()(std::size_t row, std::size_t column) const
  {
    const std::size_t place = row * static_cast<std::size_t>(stride_) + column;
    return array_.type == WINDING_INT32 ? static_cast<const std::int32_t*>(array_.data)[place]
                                        : static_cast<const std::int64_t*>(array_.data)[place];
  }

private:
  const winding_array& array_;
  std::int64_t stride_;
};

/// The faces of a caller as triangles.
class Triangles
{
public:
  Triangles(const winding_array& points, const winding_polygons* polygons);

  /// Makes points one that are up to `tolerance` from each other (SnappedPoints.h). Throws
  /// Interrupted.
  void weld(double tolerance, Executor& executor);

  const TrianglesView& view() const { return view_; }
  std::vector<TrianglesView> views() const { return {view_}; }

  /// The number of polygons, and the first triangle of one.
  std::size_t polygons() const { return starts_.empty() ? triangles() : starts_.size() - 1; }
  std::size_t triangles() const { return view_.triangles.size(); }
  std::size_t firstOf(std::size_t polygon) const
  {
    return starts_.empty() ? polygon : starts_[polygon];
  }

  /// Calls visit(polygon, n) for each polygon with a triangle that sanitize() keeps, where n is the
  /// number of the first one in the surface.
  template <class Visit> void forEachKept(const Visit& visit) const
  {
    std::size_t kept = 0;
    for (std::size_t polygon = 0; polygon < this->polygons(); ++polygon)
    {
      const std::size_t first = kept;
      for (std::size_t t = this->firstOf(polygon); t < this->firstOf(polygon + 1); ++t)
      {
        kept += this->isKept(t);
      }
      if (kept > first)
      {
        visit(polygon, first);
      }
    }
  }

private:
  bool isKept(std::size_t triangle) const;

  TrianglesView view_;
  std::vector<double> welded_;      ///< points that were moved
  std::vector<std::int64_t> ids_;   ///< of fans, and of triangles with strides
  std::vector<char> isContinued_;   ///< by triangle
  std::vector<std::size_t> starts_; ///< first triangle of each polygon; none for triangles
};

///@{
/// Choices and options of the core. Throw Refusal for values out of range.
InsideTest insideTestOf(const winding_rule* rule); ///< null for the defaults
FieldOptions optionsOf(const winding_options* options);
double toleranceOf(const winding_options* options);
Grid gridOf(const winding_grid* grid);
///@}

/// The caller's wishes for a call, and threads.
class Call
{
public:
  explicit Call(const winding_run* wished)
    : run_(known(wished, defaultRun()))
    , executor(run_)
    , run{executor, [this](const Message& message) { this->warn(message); }, {}}
  {
    if (run_.free_memory > 0)
    {
      run.freeMemory = [this]
      {
        return run_.free_memory;
      };
    }
  }
  Call(const Call&) = delete;
  void operator=(const Call&) = delete;

  /// Has warnings begin with the name of a source from now on, or not if it is empty.
  void nameSource(const std::string& name) { prefix_ = name.empty() ? "" : "'" + name + "': "; }

  /// Gives the caller a warning.
  void warn(const Message& message) const;
  void warn(const std::vector<Message>& messages) const;

  double longestExpectedTime() const { return run_.longest_expected_time; }

private:
  winding_run run_;
  std::string prefix_;

public:
  ThreadExecutor executor;
  Run run; ///< for tasks
};

/// The words of messages that a caller wants.
FrontEnd frontEndOf(const winding_run* run);

/// Writes a refusal, unless there is none to write.
void write(winding_refusal* refusal, const char* parameter, const std::string& text);

/// Writes the message of a refusal in the caller's words.
void write(winding_refusal* refusal, const Message& message, const winding_run* run);

/// Does the work of a call, and returns how it ended. No exception leaves it.
template <class Work>
winding_status guarded(const winding_run* run, winding_refusal* refusal, const Work& work) noexcept
{
  try
  {
    write(refusal, "", "");
    known(run, defaultRun()); // so that what is caught below finds a right one
    work();
    return WINDING_OK;
  }
  catch (const Interrupted&)
  {
    return WINDING_INTERRUPTED;
  }
  catch (const std::bad_alloc&)
  {
    write(refusal, "", "not enough memory");
    return WINDING_NO_MEMORY;
  }
  catch (const std::length_error&)
  {
    write(refusal, "", "not enough memory");
    return WINDING_NO_MEMORY;
  }
  catch (const Misuse& misuse)
  {
    write(refusal, "", misuse.what());
    return WINDING_MISUSED;
  }
  catch (const Refusal& found)
  {
    try
    {
      write(refusal, found.message(), run);
      return dynamic_cast<const OutOfMemory*>(&found) ? WINDING_NO_MEMORY : WINDING_REFUSED;
    }
    catch (const std::exception&)
    {
      write(refusal, "", "not enough memory");
      return WINDING_NO_MEMORY;
    }
  }
  catch (const std::exception& fault)
  {
    write(refusal, "", fault.what());
    return WINDING_FAILED;
  }
  catch (...)
  {
    write(refusal, "", "unknown fault");
    return WINDING_FAILED;
  }
}

} // namespace winding::c
