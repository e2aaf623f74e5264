// A fuzzer of one guard against broken files (FileGuards.h): its function and the suffix of its
// files come from CMake. A guard takes a file or throws Failure; all else is a defect.

#include "FuzzedFile.h"

#include "input/FileGuards.h"
#include "program/Failure.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const fuzz::FuzzedFile file(WINDING_FUZZ_SUFFIX);
  file.write(data, size);
  try
  {
    WINDING_FUZZ_GUARD(file.name());
  }
  catch (const Failure&)
  {
  }
  return 0;
}
