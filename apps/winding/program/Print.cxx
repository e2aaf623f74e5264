// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/Print.h"

#include "program/Failure.h"

#include <charconv>
#include <iostream>

void requirePrinted()
{
  std::cout.flush();
  if (!std::cout)
  {
    throw Failure(EXIT_REFUSED, "standard output cannot be written to; is the disk full?");
  }
}

void print(const std::string& text)
{
  std::cout << text << '\n';
  requirePrinted();
}

void print(const Json& object)
{
  // File names may hold any bytes, JSON only UTF-8.
  print(object.dump(2, ' ', false, Json::error_handler_t::replace));
}

std::string shown(double value, int digits)
{
  char text[64];
  return {
    text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}
