// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtk/ErrorLog.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberReader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

/**
 * @file
 * Files of some contents, what readers give for them, and what they say of those that they refuse.
 */

namespace reading
{

/// A temporary file with some contents, removed with the object.
class TextFile
{
public:
  TextFile(const std::string& contents, const std::string& suffix)
    : path_((std::filesystem::temp_directory_path() /
             ("winding-readers-test-" + std::to_string(getpid()) + suffix))
              .string())
  {
    std::ofstream(path_, std::ios::binary) << contents;
  }
  ~TextFile() { std::filesystem::remove(path_); }

  const char* path() const { return path_.c_str(); }

private:
  std::string path_;
};

/// Returns the output of the reader, which is to say nothing.
inline vtkSmartPointer<vtkPolyData> read(const std::string& contents, const std::string& suffix)
{
  const TextFile file(contents, suffix);
  vtkNew<vtkWindingNumberReader> reader;
  const ErrorLog log(reader);
  reader->SetFileName(file.path());
  reader->Update();
  EXPECT_EQ(log.errors(), "");
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  return reader->GetOutput();
}

/// Expects one error that says `part`, an error code, and an output without points.
inline void expectRefusal(const std::string& contents, const std::string& part, unsigned long code,
  const std::string& suffix)
{
  const TextFile file(contents, suffix);
  vtkNew<vtkWindingNumberReader> reader;
  const ErrorLog log(reader);
  reader->SetFileName(file.path());
  reader->Update();
  EXPECT_NE(log.errors().find(part), std::string::npos) << contents << "\n" << log.errors();
  EXPECT_NE(log.errors().find(file.path()), std::string::npos);
  EXPECT_EQ(reader->GetErrorCode(), code) << contents;
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
}

/// The codes of errors.
inline constexpr unsigned long format = vtkErrorCode::FileFormatError;
inline constexpr unsigned long end = vtkErrorCode::PrematureEndOfFileError;

/// Expects a tuple of an array of vectors.
inline void expectRow(vtkDataArray* array, vtkIdType row, double x, double y, double z)
{
  ASSERT_NE(array, nullptr);
  const double* tuple = array->GetTuple3(row);
  EXPECT_EQ(tuple[0], x);
  EXPECT_EQ(tuple[1], y);
  EXPECT_EQ(tuple[2], z);
}

} // namespace reading
