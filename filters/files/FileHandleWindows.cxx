// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/FileHandle.h"

#include <algorithm>

#ifndef NOMINMAX
#define NOMINMAX
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#include <windows.h>

namespace winding
{

namespace
{

/// Returns a text of UTF-8 in UTF-16, and nothing for a text that is not UTF-8.
std::wstring wide(const std::string& text)
{
  const auto length = static_cast<int>(text.size());
  const auto convert = [&](wchar_t* units, int count)
  {
    return MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text.data(), length, units, count);
  };
  std::wstring units(static_cast<std::size_t>(std::max(convert(nullptr, 0), 0)), L'\0');
  convert(units.data(), static_cast<int>(units.size()));
  return units;
}

/// Returns the answer for an error of the system.
FileAnswer answerFor(DWORD error)
{
  const bool isMissing = error == ERROR_FILE_NOT_FOUND || error == ERROR_PATH_NOT_FOUND ||
                         error == ERROR_INVALID_NAME || error == ERROR_BAD_NETPATH ||
                         error == ERROR_BAD_PATHNAME;
  return isMissing ? FileAnswer::notFound : FileAnswer::cannotOpen;
}

} // namespace

FileHandle::FileHandle(const std::string& name)
{
  const std::wstring path = wide(name);
  const DWORD attributes = GetFileAttributesW(path.c_str());
  if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0)
  {
    answer_ = FileAnswer::isFolder;
    return;
  }
  // Other programs may change, rename and remove the file meanwhile, as they may elsewhere.
  const HANDLE handle =
    CreateFileW(path.c_str(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
      nullptr, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  handle_ = reinterpret_cast<std::intptr_t>(handle);
  if (handle == INVALID_HANDLE_VALUE)
  {
    answer_ = answerFor(GetLastError());
    return;
  }
  if (GetFileType(handle) != FILE_TYPE_DISK)
  {
    answer_ = FileAnswer::isSpecial;
    return;
  }
  answer_ = FileAnswer::opened;
  LARGE_INTEGER size = {};
  if (GetFileSizeEx(handle, &size) != 0)
  {
    size_ = static_cast<std::size_t>(size.QuadPart);
  }
}

FileHandle::~FileHandle()
{
  if (handle_ != -1)
  {
    CloseHandle(reinterpret_cast<HANDLE>(handle_));
  }
}

std::size_t FileHandle::read(std::size_t offset, char* bytes, std::size_t count) const
{
  // Each call has a place of its own, whatever other threads read.
  OVERLAPPED place = {};
  place.Offset = static_cast<DWORD>(offset & 0xFFFFFFFFu);
  place.OffsetHigh = static_cast<DWORD>(static_cast<unsigned long long>(offset) >> 32);
  const auto atMost = static_cast<DWORD>(std::min<std::size_t>(count, 1u << 30));
  DWORD taken = 0;
  const auto handle = reinterpret_cast<HANDLE>(handle_);
  return ReadFile(handle, bytes, atMost, &taken, &place) != 0 ? taken : 0;
}

} // namespace winding
