#include "files/ExactNumber.h"

#include <charconv>

std::string exact(double value)
{
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 17).ptr};
}
