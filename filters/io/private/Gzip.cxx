// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/Gzip.h"

#include "base/Executor.h"
#include "pipeline/FreeMemory.h"

#include <vtk_zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <utility>

namespace winding
{

namespace
{

constexpr std::size_t bytesAtOnce = 1 << 20;

/// A byte that is packed by deflate holds at most this number of bytes.
constexpr std::size_t mostPerByte = 1032;

/// Unpacks the parts of a file, one behind the other.
class Gzip
{
public:
  Gzip(const InputFile& packed, Executor& executor)
    : packed_(packed)
    , executor_(executor)
    , input_(std::min(bytesAtOnce, packed.size()))
  {
    constexpr int gzipOnly = 16;
    if (inflateInit2(&stream_, MAX_WBITS + gzipOnly) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Gzip() { inflateEnd(&stream_); }
  Gzip(const Gzip&) = delete;
  void operator=(const Gzip&) = delete;

  PlainArray<char> content()
  {
    this->grow(this->promisedSize());
    bool isAtStart = true; // of a part
    while (this->hasInput())
    {
      if (isAtStart && used_ > 0 && *stream_.next_in == 0)
      {
        break; // blocks of tapes are filled up with zeros
      }
      isAtStart = this->step();
    }
    if (!isAtStart)
    {
      packed_.refuse("ends before it is unpacked; it is damaged", FileFault::ends);
    }
    content_.resize(used_);
    return std::move(content_);
  }

private:
  /// Returns the size that the last bytes of the file promise, within what it can hold.
  std::size_t promisedSize() const
  {
    unsigned char last[4] = {};
    const std::size_t count = std::min(sizeof last, packed_.size());
    packed_.read(packed_.size() - count, reinterpret_cast<char*>(last), count);
    const std::size_t promised =
      last[0] | last[1] << 8 | last[2] << 16 | std::size_t(last[3]) << 24;
    return std::min(promised, mostPerByte * packed_.size()) + 1;
  }

  /// Makes room for `size` bytes in all.
  void grow(std::size_t size)
  {
    refuseBeyondFreeMemory(
      static_cast<double>(size), packed_.name() + " unpacked", {{"unpack a smaller part", {}}});
    content_.resize(size);
  }

  /// Reads more where all input is used up; false at the end of the file.
  bool hasInput()
  {
    if (stream_.avail_in == 0 && next_ < packed_.size())
    {
      const std::size_t count = std::min(input_.size(), packed_.size() - next_);
      packed_.read(next_, input_.data(), count);
      next_ += count;
      stream_.next_in = reinterpret_cast<unsigned char*>(input_.data());
      stream_.avail_in = static_cast<unsigned int>(count);
      executor_.runBriefly(1, [](std::size_t) {}); // may interrupt
    }
    return stream_.avail_in > 0;
  }

  /// Unpacks some bytes. Returns whether a part has ended.
  bool step()
  {
    if (used_ == content_.size())
    {
      this->grow(used_ + used_ / 2 + bytesAtOnce);
    }
    const std::size_t room = std::min(content_.size() - used_, bytesAtOnce);
    stream_.next_out = reinterpret_cast<unsigned char*>(content_.data() + used_);
    stream_.avail_out = static_cast<unsigned int>(room);
    const int answer = inflate(&stream_, Z_NO_FLUSH);
    used_ += room - stream_.avail_out;
    if (answer == Z_MEM_ERROR)
    {
      throw std::bad_alloc();
    }
    if (answer != Z_OK && answer != Z_BUF_ERROR && answer != Z_STREAM_END)
    {
      packed_.refuse(used_ == 0 ? "is not packed by gzip; give it a suffix that fits"
                                : "cannot be unpacked; it is damaged");
    }
    if (answer == Z_STREAM_END)
    {
      inflateReset(&stream_);
    }
    return answer == Z_STREAM_END;
  }

  const InputFile& packed_;
  Executor& executor_;
  PlainArray<char> input_;
  std::size_t next_ = 0; ///< the place in the file behind the input
  PlainArray<char> content_;
  std::size_t used_ = 0; ///< bytes of the content
  z_stream stream_ = {};
};

} // namespace

PlainArray<char> unpackGzip(const InputFile& packed, Executor& executor)
{
  return Gzip(packed, executor).content();
}

} // namespace winding
