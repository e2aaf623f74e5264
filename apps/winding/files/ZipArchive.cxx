// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/ZipArchive.h"

#include "files/Text.h"
#include "program/Failure.h"

#include <algorithm>
#include <filesystem>

#include <zip.h>

ZipArchive::ZipArchive(const std::string& fileName)
  : fileName_(fileName)
  , archive_(zip_open(fileName.c_str(), ZIP_RDONLY, nullptr), zip_discard)
{
  if (!archive_)
  {
    this->refuse("is no whole zip archive; it is cut off or damaged");
  }
  const auto count = static_cast<std::uint64_t>(zip_get_num_entries(archive_.get(), 0));
  for (const bool hasCapitals : {true, false})
  {
    for (std::uint64_t i = 0; i < count; ++i)
    {
      const char* const name = zip_get_name(archive_.get(), i, 0);
      const std::string path = plainPath(name ? name : "");
      indices_.emplace(hasCapitals ? path : inSmallLetters(path), i);
    }
  }
}

std::optional<std::uint64_t> ZipArchive::find(const std::string& name) const
{
  for (const std::string& spelling : {name, inSmallLetters(name)})
  {
    if (const auto found = indices_.find(spelling); found != indices_.end())
    {
      return found->second;
    }
  }
  return std::nullopt;
}

bool ZipArchive::has(const std::string& name) const
{
  return this->find(name).has_value();
}

void ZipArchive::read(
  const std::string& name, const std::function<void(std::string_view)>& take) const
{
  const std::optional<std::uint64_t> index = this->find(name);
  if (!index)
  {
    this->refuse("has no " + name + " in it; it is damaged");
  }
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
    zip_fopen_index(archive_.get(), *index, 0), zip_fclose);
  char bytes[1 << 16];
  zip_int64_t count = -1;
  while (file && (count = zip_fread(file.get(), bytes, sizeof bytes)) > 0)
  {
    take(std::string_view(bytes, static_cast<std::size_t>(count)));
  }
  if (count < 0) // of its sum, too
  {
    this->refuse("its " + name +
                 " cannot be unpacked; it is damaged, has a password, or is packed in an unusual "
                 "way");
  }
}

double ZipArchive::unpackedBytes(double most) const
{
  double bytes = 0;
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i)
  {
    zip_stat_t about;
    constexpr zip_uint64_t both = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
    if (zip_stat_index(archive_.get(), static_cast<zip_uint64_t>(i), 0, &about) == 0 &&
        (about.valid & both) == both)
    {
      bytes +=
        std::min(static_cast<double>(about.size), most * static_cast<double>(about.comp_size));
    }
  }
  return bytes;
}

void ZipArchive::refuse(const std::string& what) const
{
  throw Failure(EXIT_REFUSED, fileName_, what);
}

std::string plainPath(const std::string& path)
{
  std::string plain = withoutPercentCodes(path);
  std::replace(plain.begin(), plain.end(), '\\', '/');
  plain = std::filesystem::path('/' + plain).lexically_normal().string();
  plain.erase(0, std::min(plain.find_first_not_of('/'), plain.size()));
  return plain;
}
