// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/PlyHeader.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace winding
{

/// Where the numbers of an item of a binary file stand in its bytes.
class PlyLayout
{
public:
  /// All must live as long as the layout.
  PlyLayout(const InputFile& file, PlyEncoding encoding, const PlyElement& element);

  /// Lays out the item that begins at `at`. False if it does not end at `end` or before. Throws
  /// FileRefusal for lists whose length cannot be one.
  bool find(const char* at, const char* end);

  /// Whether `count` items from `at` on, one behind the other, are laid out in this way.
  bool fits(const char* at, std::size_t count) const;

  const PlyElement& element() const { return element_; }
  PlyEncoding encoding() const { return encoding_; }

  /// Bytes of the whole item.
  std::size_t bytes() const { return bytes_; }

  /// A property: where its first number stands, and how many there are.
  struct Place
  {
    std::size_t offset;
    std::size_t length;
  };
  const Place& place(const PlyProperty& property) const
  {
    return places_[static_cast<std::size_t>(&property - element_.properties.data())];
  }

private:
  std::size_t lengthAt(const PlyProperty& property, const char* at) const;

  const InputFile& file_;
  PlyEncoding encoding_;
  const PlyElement& element_;
  std::vector<Place> places_; ///< one for each property
  std::size_t bytes_ = 0;
};

/// Some items of the same layout, one behind the other.
struct PlyItems
{
  const char* at;          ///< the first of them
  std::size_t count;       ///< how many they are
  std::size_t item;        ///< the number of the first one
  std::size_t entry;       ///< entries of the list at hand in all items before
  const PlyLayout& layout; ///< where their numbers stand
};

/**
 * The items of an element of a binary file. Where all lists have the lengths of the first item's,
 * as in meshes of triangles, threads take the items as they stand. Else one thread finds their
 * places first.
 */
class PlyElementReader
{
public:
  /// Entries of `list` are counted; it may be null. The items begin
  /// at the place `start`. All must live as long as the reader.
  PlyElementReader(const InputFile& file, PlyEncoding encoding, const PlyElement& element,
    const PlyProperty* list, std::size_t start);

  /// Finds the end of the items: of those without lists, and of those that seem to be like the
  /// first one, at once; of others by going through them. Throws FileRefusal where the file ends
  /// before, and for lists whose length cannot be one.
  void findEnd();

  /// The place behind the items, and the entries of the list in all of them, as found.
  std::size_t end() const { return blocks_.back().offset; }
  std::size_t entries() const { return blocks_.back().entry; }

  /**
   * Calls work(items) for all items, in parts, on the executor. False where the items turned out
   * not to be like the first one: some parts were given to work() in vain, end() and entries() have
   * changed, and read() is to be called again. Work may throw, as in runOrderedBlocks().
   */
  bool read(const std::function<void(const PlyItems&)>& work, Executor& executor);

  /// Makes sure of the end where nothing of the items is wanted.
  void passOver(Executor& executor);

private:
  /// Where a block begins.
  struct Block
  {
    std::size_t offset; ///< the place of its first item in the file
    std::size_t item;   ///< the number of its first item
    std::size_t entry;  ///< entries of the list in all items before
  };

  bool guessEnd();
  void walk();
  void readBlock(std::size_t block, const std::function<void(const PlyItems&)>& work) const;

  const InputFile& file_;
  PlyEncoding encoding_;
  const PlyElement& element_;
  const PlyProperty* list_;
  PlyLayout first_; ///< of the first item
  bool hasLists_;
  bool areUniform_ = false;
  std::vector<Block> blocks_; ///< the last one is the end
};

} // namespace winding
