#include "files/ExactNumber.h"

#include <charconv>

void appendExact(std::string& text, double value)
{
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::string exact(double value)
{
  std::string text;
  appendExact(text, value);
  return text;
}
