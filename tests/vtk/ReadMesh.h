// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"

#include <string>

template <class Reader> vtkSmartPointer<vtkPolyData> readWith(const std::string& fileName)
{
  vtkNew<Reader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// A mesh or a cloud of the shared folder, by the reader for the suffix of its name.
inline vtkSmartPointer<vtkPolyData> readMesh(const std::string& fileName)
{
  const std::string suffix = fileName.substr(fileName.rfind('.'));
  return suffix == ".obj"   ? readWith<vtkOBJReader>(fileName)
         : suffix == ".ply" ? readWith<vtkPLYReader>(fileName)
         : suffix == ".stl" ? readWith<vtkSTLReader>(fileName)
                            : readWith<vtkXMLPolyDataReader>(fileName);
}
