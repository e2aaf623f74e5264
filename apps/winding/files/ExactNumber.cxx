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

std::string exact(const double vector[3], char separator)
{
  return exact(vector[0]) + separator + exact(vector[1]) + separator + exact(vector[2]);
}
