// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberClip.h"

#include "base/Executor.h"
#include "field/Field.h"
#include "pipeline/SmpExecutor.h"
#include "pipeline/VtkVersions.h"
#include "private/output/ResultArrays.h"
#include "private/probe/ClippedPart.h"
#include "private/probe/CutDistances.h"
#include "private/probe/ProbeQueries.h"
#include "private/probe/ProbeWords.h"
#include "private/source/SourceProperties.h"

#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{

constexpr double progressOfSamples = 0.6;
constexpr double progressOfDistances = 0.8;

} // namespace

vtkStandardNewMacro(vtkWindingNumberClip);

vtkSmartPointer<vtkDataObject> vtkWindingNumberClip::NewOutput(vtkDataObject* input) const
{
  if (vtkDataSet::SafeDownCast(input))
  {
    return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  return this->Superclass::NewOutput(input);
}

double vtkWindingNumberClip::GetProgressOfSamples() const
{
  return progressOfSamples;
}

const winding::ProbeWords& vtkWindingNumberClip::GetWords() const
{
  return winding::wordsOfClip;
}

/// The array of w shows whether the source is inside out.
winding::ResultOptions vtkWindingNumberClip::GetResultOptions() const
{
  return {};
}

double vtkWindingNumberClip::GetResultBytes(vtkIdType samples) const
{
  constexpr double bytesOfSide = 1;
  return this->Superclass::GetResultBytes(samples) +
         (bytesOfSide + winding::bytesPerSampleOfCuts + winding::bytesPerClippedPoint) *
           static_cast<double>(samples);
}

std::size_t vtkWindingNumberClip::GetAdditionalBytes(const winding::Field& field, vtkIdType samples)
{
  return winding::bytesOfCutDistances(field, static_cast<std::size_t>(samples));
}

void vtkWindingNumberClip::FinishSamples(
  const winding::Field& field, const winding::ProbeQueries& queries, const unsigned char* inside)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(progressOfSamples, progressOfDistances);
  this->CutDistances =
    winding::cutDistances(field, queries, inside, this->GetInsideTest(), executor);
  this->SamplesDone = 0;
}

vtkSmartPointer<vtkDataSet> vtkWindingNumberClip::PartOf(
  vtkDataSet* data, const winding::ProbeLeaf& leaf, const unsigned char*)
{
  vtkSmartPointer<vtkDataSet> part =
    winding::clippedPart(data, this->CutDistances.data() + leaf.first);
  this->SamplesDone += leaf.count;
  const double share = static_cast<double>(this->SamplesDone) /
                       static_cast<double>(std::max<std::size_t>(1, this->CutDistances.size()));
  this->UpdateProgress(progressOfDistances + (1 - progressOfDistances) * share);
  if (winding::isAborted(this))
  {
    throw winding::Interrupted();
  }
  return part;
}

int vtkWindingNumberClip::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int isDone = this->Superclass::RequestData(request, inputs, outputs);
  this->CutDistances = {};
  return isDone;
}
