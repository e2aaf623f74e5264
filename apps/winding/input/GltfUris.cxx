// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/GltfUris.h"

#include "files/Text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <istream>
#include <limits>
#include <streambuf>
#include <string_view>

namespace
{

constexpr int deepest = 1000; // brackets; real files have ten

/// Returns for each byte whether it is a digit of base 64.
std::array<bool, 256> digitsOfBase64()
{
  std::array<bool, 256> digits = {};
  for (const char first : {'A', 'a'})
  {
    std::fill_n(digits.begin() + first, 26, true);
  }
  std::fill_n(digits.begin() + '0', 10, true);
  for (const char digit : {'+', '/', '='})
  {
    digits[static_cast<unsigned char>(digit)] = true;
  }
  return digits;
}

/// The JSON of a glTF file, with data in base 64 cut short: names of files are not as long.
class ShortenedText : public std::streambuf
{
public:
  explicit ShortenedText(const std::string& fileName)
    : file_(fileName, std::ios::binary)
  {
    char header[20] = {};
    file_.read(header, sizeof header);
    if (std::string_view(header, 4) == "glTF")
    {
      std::uint32_t length = 0;
      std::memcpy(&length, header + 12, sizeof length);
      left_ = length;
      return;
    }
    file_.clear();
    file_.seekg(0);
  }

protected:
  int_type underflow() override
  {
    char* end = block_.data();
    while (end == block_.data())
    {
      const std::uint64_t wanted = std::min<std::uint64_t>(left_, block_.size());
      file_.read(block_.data(), static_cast<std::streamsize>(wanted));
      const auto count = static_cast<std::size_t>(file_.gcount());
      if (count == 0)
      {
        return traits_type::eof();
      }
      left_ -= count;
      end = this->shorten(count);
    }
    this->setg(block_.data(), block_.data(), end);
    return traits_type::to_int_type(block_[0]);
  }

private:
  /// Drops what is too long from the first bytes of the block. Returns their new end.
  char* shorten(std::size_t count)
  {
    constexpr std::size_t longest = 1 << 14;
    char* end = block_.data();
    for (std::size_t i = 0; i < count; ++i)
    {
      const char letter = block_[i];
      run_ = digits_[static_cast<unsigned char>(letter)] ? run_ + 1 : 0;
      *end = letter;
      end += run_ <= longest ? 1 : 0;
    }
    return end;
  }

  std::ifstream file_;
  std::uint64_t left_ = std::numeric_limits<std::uint64_t>::max(); // bytes of JSON
  std::size_t run_ = 0;                                            // digits up to here
  std::vector<char> block_ = std::vector<char>(1 << 16);
  std::array<bool, 256> digits_ = digitsOfBase64();
};

/// Takes uri of {"buffers": [{"uri": ...}], "images": [{"uri": ...}]} while JSON is parsed.
class UriTaker : public nlohmann::json_sax<nlohmann::json>
{
public:
  std::vector<std::string> uris;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool string(string_t& text) override
  {
    const bool isOfFile = table_ == "buffers" || table_ == "images";
    if (depth_ == 3 && isOfFile && key_ == "uri" && !startsWith(text, "data:"))
    {
      uris.push_back(text);
    }
    return true;
  }
  bool key(string_t& name) override
  {
    if (depth_ == 1 || depth_ == 3)
    {
      (depth_ == 1 ? table_ : key_) = name;
    }
    return true;
  }
  bool start_object(std::size_t) override { return ++depth_ <= deepest; }
  bool start_array(std::size_t) override { return ++depth_ <= deepest; }
  bool end_object() override { return --depth_ >= 0; }
  bool end_array() override { return --depth_ >= 0; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override
  {
    return false; // the reader reports it
  }

private:
  int depth_ = 0;
  std::string table_, key_; // the last names of values in the file and in the table's objects
};

} // namespace

std::vector<std::string> urisInGltf(const std::string& fileName)
{
  ShortenedText buffer(fileName);
  std::istream text(&buffer);
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  for (std::size_t i = 0; i < byteOrderMark.size() &&
                          text.peek() == std::char_traits<char>::to_int_type(byteOrderMark[i]);
       ++i)
  {
    text.get();
  }
  text >> std::ws;
  UriTaker taker;
  if (text.peek() == '{')
  {
    nlohmann::json::sax_parse(text, &taker, nlohmann::json::input_format_t::json, false);
  }
  return taker.uris;
}
