// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/LoadedReaders.h"

#include "files/ThreeMfReader.h"

#if defined(WINDING_HDF_FIRST_STEP)
#include "files/HdfReader.h"
#elif defined(WINDING_HDF)
#include "vtkHDFReader.h"
using HdfReader = vtkHDFReader;
#endif

#include <string>

namespace
{

template <class Reader> vtkAlgorithm* readerOf(const char* fileName)
{
  Reader* const reader = Reader::New();
  reader->SetFileName(fileName);
  return reader;
}

} // namespace

extern "C" __attribute__((visibility("default"))) vtkAlgorithm* windingMakeReader(
  const char* suffix, const char* fileName)
{
#ifdef WINDING_HDF
  if (suffix == std::string(".vtkhdf"))
  {
    return readerOf<HdfReader>(fileName);
  }
#endif
  return suffix == std::string(".3mf") ? readerOf<ThreeMfReader>(fileName) : nullptr;
}
