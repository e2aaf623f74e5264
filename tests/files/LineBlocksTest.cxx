// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/TemporaryFile.h"

#include "files/LineBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

using namespace winding;

namespace
{

/// Lines of random lengths, some of which end with a backslash.
std::string randomText(std::mt19937& random)
{
  std::string text;
  const int lines = static_cast<int>(random() % 30);
  for (int line = 0; line < lines; ++line)
  {
    text += std::string(random() % 9, 'a');
    text += random() % 5 == 0 ? "\\" : "";
    text += random() % 3 == 0 ? "\r\n" : "\n";
  }
  return text + (random() % 2 == 0 || text.empty() ? "end" : "");
}

/// Returns a text with blanks for the ends of lines that end with a backslash.
std::string joined(std::string text)
{
  for (const std::string end : {"\\\n", "\\\r\n"})
  {
    for (std::size_t at = 0; (at = text.find(end, at)) != std::string::npos;)
    {
      text.replace(at, end.size(), end.size(), ' ');
    }
  }
  text.back() = '\n'; // an end of the text, joined or not
  return text;
}

bool mayBegin(const std::string& text, std::size_t at, LineBlocks::Backslash backslash)
{
  const std::string before = text.substr(0, at);
  const auto endsWith = [&before](const std::string& end)
  {
    return before.size() >= end.size() &&
           before.compare(before.size() - end.size(), end.size(), end) == 0;
  };
  const bool isJoined = endsWith("\\\n") || endsWith("\\\r\n");
  return endsWith("\n") && (backslash == LineBlocks::Backslash::isLetter || !isJoined);
}

TEST(LineBlocks, AreTheFileInWholeLines)
{
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round)
  {
    const std::string text = randomText(random);
    const TemporaryFile file(text);
    const InputFile input(file.name());
    const std::size_t bytes = 1 + random() % 40;
    const auto backslash =
      round % 2 == 0 ? LineBlocks::Backslash::joinsLines : LineBlocks::Backslash::isLetter;
    const LineBlocks blocks(input, 0, bytes, backslash);
    std::string read;
    for (std::size_t block = 0; block < blocks.count(); ++block)
    {
      const TextBlock part = blocks.read(block);
      ASSERT_EQ(part.offsetOf(part.text().data()), read.size());
      ASSERT_TRUE(read.empty() || mayBegin(text, read.size(), backslash)) << text;
      ASSERT_EQ(part.text().back(), '\n');
      read += part.text();
    }
    const std::string whole = text.back() == '\n' ? text : text + "\n";
    ASSERT_EQ(read, backslash == LineBlocks::Backslash::isLetter ? whole : joined(whole));
  }
}

TEST(LineBlocks, MayEndWithCarriageReturns)
{
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round)
  {
    std::string text = randomText(random), plain;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
      const bool isEnd = text[i] == '\n' && (i == 0 || text[i - 1] != '\r');
      text[i] = isEnd && random() % 2 == 0 ? '\r' : text[i];
    }
    for (std::size_t i = 0; i < text.size(); ++i)
    {
      plain += text[i] == '\r' && text[i + 1] != '\n' ? '\n' : text[i];
    }
    const TemporaryFile file(text);
    const InputFile input(file.name());
    const LineBlocks blocks(input, 0, 1 + random() % 10);
    std::string read;
    for (std::size_t block = 0; block < blocks.count(); ++block)
    {
      read += blocks.read(block).text();
      const std::size_t place = std::min(read.size(), plain.size());
      ASSERT_EQ(input.lineOf(place),
        1 + std::count(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
    }
    ASSERT_EQ(read, plain.back() == '\n' ? plain : plain + "\n");
  }
}

TEST(LineBlocks, CommentsAreNotJoined)
{
  const TemporaryFile file("a \\\n# b \\\nc #d\\\r\n\\\ne#f\\\n #\\\ng \\\\\nh\\");
  const InputFile input(file.name());
  const LineBlocks blocks(input, 0, 1000, LineBlocks::Backslash::joinsLines);
  EXPECT_EQ(blocks.read(0).text(), "a   # b \\\nc #d\\\r\n  e#f   #\\\ng \\  h \n");
}

TEST(LineBlocks, LongLinesAreBlocksOfTheirOwn)
{
  const std::string text = std::string(100000, 'x') + "\n" + std::string(3, 'y') + "\nz\n";
  const TemporaryFile file(text);
  const InputFile input(file.name());
  const LineBlocks blocks(input, 0, 1000);
  ASSERT_EQ(blocks.count(), 2u);
  EXPECT_EQ(blocks.read(0).text().size(), 100001u);
  EXPECT_EQ(blocks.read(1).text(), "yyy\nz\n");
}

TEST(LineBlocks, BackslashesDoNotMakeThemLonger)
{
  std::string text;
  for (int line = 0; line < 100; ++line)
  {
    text += "1,2,3,C:\\folder\\\n";
  }
  const TemporaryFile file(text);
  const InputFile input(file.name());
  EXPECT_EQ(LineBlocks(input, 0, 100).count(), 17u) << "six lines of 17 bytes each";
  EXPECT_EQ(LineBlocks(input, 0, 100, LineBlocks::Backslash::joinsLines).count(), 1u);
}

TEST(LineBlocks, BeginWhereTheyAreTold)
{
  const TemporaryFile file("header\na\nb\n");
  const InputFile input(file.name());
  const LineBlocks blocks(input, 7);
  ASSERT_EQ(blocks.count(), 1u);
  EXPECT_EQ(blocks.read(0).text(), "a\nb\n");
  EXPECT_EQ(LineBlocks(input, input.size()).count(), 0u);
}

FileFault faultOf(const char* name)
{
  try
  {
    const InputFile file(name);
  }
  catch (const FileRefusal& refusal)
  {
    return refusal.fault();
  }
  ADD_FAILURE() << name << " was opened";
  return FileFault::format;
}

TEST(InputFile, WhatCannotBeRead)
{
  EXPECT_EQ(faultOf(nullptr), FileFault::noName);
  EXPECT_EQ(faultOf(""), FileFault::noName);
  EXPECT_EQ(faultOf("/nowhere/at/all"), FileFault::notFound);
  EXPECT_EQ(faultOf("/"), FileFault::cannotOpen);
  EXPECT_EQ(faultOf("/dev/zero"), FileFault::cannotOpen);
  const TemporaryFile empty("");
  EXPECT_EQ(faultOf(empty.name()), FileFault::ends);
}

TEST(InputFile, PackedFilesNeedWhatUnpacksThem)
{
  const TemporaryFile file("packed", ".obj.gz");
  const InputFile unpacked(file.name(),
    [](const InputFile& packed)
    {
      EXPECT_EQ(packed.size(), 6U);
      winding::PlainArray<char> content(3);
      std::copy_n("v 1", 3, content.data());
      return content;
    });
  EXPECT_EQ(unpacked.size(), 3U);
  char letters[2];
  unpacked.read(1, letters, 2);
  EXPECT_EQ(std::string(letters, 2), " 1");
  EXPECT_THROW(unpacked.read(2, letters, 2), FileRefusal);
  const std::string name = file.name();
  EXPECT_EQ(unpacked.unpackedName(), name.substr(0, name.size() - 3));
  EXPECT_THROW(InputFile(file.name()), FileRefusal);
}

TEST(InputFile, LinesAreCountedFromOne)
{
  const TemporaryFile file("ab\n\nc");
  const InputFile input(file.name());
  EXPECT_EQ(input.lineOf(0), 1u);
  EXPECT_EQ(input.lineOf(2), 1u);
  EXPECT_EQ(input.lineOf(3), 2u);
  EXPECT_EQ(input.lineOf(4), 3u);
}

TEST(InputFile, FilesThatShrinkAreRefused)
{
  const TemporaryFile file("0123456789");
  const InputFile input(file.name());
  std::filesystem::resize_file(file.name(), 5);
  char bytes[10];
  input.read(0, bytes, 5);
  EXPECT_THROW(input.read(0, bytes, 10), FileRefusal);
}

} // namespace
