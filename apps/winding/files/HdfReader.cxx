// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/HdfReader.h"

#include "program/Failure.h"

#include "vtkAppendDataSets.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtk_hdf5.h"

#include <algorithm>
#include <numeric>
#include <vector>

vtkStandardNewMacro(HdfReader);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// A thing of an HDF5 file, which is closed in the end; a negative number if it is not there.
class Handle
{
public:
  Handle(hid_t id, herr_t (*close)(hid_t))
    : id_(id)
    , close_(close)
  {
  }
  ~Handle()
  {
    if (id_ >= 0)
    {
      close_(id_);
    }
  }
  Handle(const Handle&) = delete;
  void operator=(const Handle&) = delete;

  hid_t id() const { return id_; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Returns the number of steps in a file; 0 where it has none.
long long countIn(hid_t file)
{
  const Handle count(
    H5Aopen_by_name(file, "/VTKHDF/Steps", "NSteps", H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Handle space(H5Aget_space(count.id()), H5Sclose);
  long long steps = 0;
  const bool isRead = H5Sget_simple_extent_npoints(space.id()) == 1 &&
                      H5Aread(count.id(), H5T_NATIVE_LLONG, &steps) >= 0;
  return isRead ? steps : 0;
}

/// Returns the first number of an array on steps, or `otherwise` where there is none.
long long firstOf(hid_t file, const char* array, long long otherwise)
{
  const Handle set(H5Dopen2(file, array, H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(set.id()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  std::vector<long long> numbers(count > 0 ? static_cast<std::size_t>(count) : 0);
  const bool isRead = count > 0 && H5Dread(set.id(), H5T_NATIVE_LLONG, H5S_ALL, H5S_ALL,
                                     H5P_DEFAULT, numbers.data()) >= 0;
  return isRead ? numbers[0] : otherwise;
}

} // namespace

int HdfReader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!this->Superclass::RequestInformation(request, inputs, outputs))
  {
    return 0;
  }
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // what is missing is asked for
  const Handle file(H5Fopen(this->FileName, H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const long long count = countIn(file.id());
  if (count < 1)
  {
    return 1;
  }
  constexpr long long most = 1 << 24;
  const long long parts = firstOf(file.id(), "/VTKHDF/Steps/NumberOfParts", 1);
  for (const char* const offsets : {"/VTKHDF/Steps/PartOffsets", "/VTKHDF/Steps/PointOffsets",
         "/VTKHDF/Steps/CellOffsets", "/VTKHDF/Steps/ConnectivityIdOffsets"})
  {
    if (firstOf(file.id(), offsets, 0) != 0 || count > most || parts < 1 || parts > most)
    {
      throw Failure(EXIT_REFUSED, this->FileName,
        "has time steps in an order that this VTK does not know; save the first one alone");
    }
  }
  parts_ = static_cast<int>(parts);
  std::vector<double> steps(static_cast<std::size_t>(count));
  std::iota(steps.begin(), steps.end(), 0);
  outputs->GetInformationObject(0)->Set(
    Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(count));
  return 1;
}

int HdfReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (parts_ == 0)
  {
    return this->Superclass::RequestData(request, inputs, outputs);
  }
  vtkInformation* const info = outputs->GetInformationObject(0);
  vtkDataSet* const output = vtkDataSet::GetData(info);
  const int piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const int pieces = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
  vtkNew<vtkAppendDataSets> append;
  append->SetOutputDataSetType(output->GetDataObjectType());
  int isRead = 1;
  for (int part = 0; part < parts_ && isRead; ++part)
  {
    constexpr int more = 1 << 30; // pieces than parts, so that each has one at most
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), part);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), more);
    isRead = this->Superclass::RequestData(request, inputs, outputs);
    auto copy = vtkSmartPointer<vtkDataSet>::Take(output->NewInstance());
    copy->ShallowCopy(output);
    append->AddInputData(copy);
    output->Initialize(); // VTK's reader appends to it
  }
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  append->Update();
  output->ShallowCopy(append->GetOutputDataObject(0));
  return isRead;
}
