// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/DealtProbe.h"

#include "commands/FilterSettings.h"
#include "options/Options.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"
#include "program/Progress.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberProbe.h"

#include <algorithm>
#include <string>

namespace
{

void execute(vtkWindingNumberProbe& probe, const Options& options, Messages& messages)
{
  const Progress progress(&probe, Phase::evaluating, messages.isQuiet());
  parallel::agree(
    [&]
    {
      probe.Update();
      checkFilter(probe.GetStatus(),
        probe.GetQueriesWereRefused() ? options.queries : options.input, messages);
    });
}

/// Refuses queries that a probe would refuse, such as cells that contradict themselves, for bare
/// points no longer show that. The probe that looks at them has a tetrahedron for its source.
void checkQueries(vtkDataSet* queries, const Options& options, Messages& messages)
{
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(0, 0, 0);
  corners->InsertNextPoint(1, 0, 0);
  corners->InsertNextPoint(0, 1, 0);
  corners->InsertNextPoint(0, 0, 1);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({0, 2, 1});
  triangles->InsertNextCell({0, 1, 3});
  triangles->InsertNextCell({1, 2, 3});
  triangles->InsertNextCell({0, 3, 2});
  vtkNew<vtkPolyData> tetrahedron;
  tetrahedron->SetPoints(corners);
  tetrahedron->SetPolys(triangles);
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetNamesInMessages(vtkWindingNumberAlgorithm::PROGRAM_NAMES);
  probe->SetController(nullptr);
  probe->SetInputDataObject(queries);
  probe->SetSourceData(tetrahedron);
  probe->SetMethod(vtkWindingNumberProbe::DIRECT);
  probe->SetNumberOfThreads(options.threads);
  probe->Update();
  checkFilter(probe->GetStatus(), options.queries, messages);
}

/// How many of the queries belong to a rank and to all ranks before it.
vtkIdType endOfDeal(vtkIdType queries, int rank)
{
  return static_cast<vtkIdType>(static_cast<double>(queries) * (rank + 1.0) / parallel::count());
}

vtkIdType startOfDeal(vtkIdType queries, int rank)
{
  return rank == 0 ? 0 : endOfDeal(queries, rank - 1);
}

/// The points that are dealt to this rank.
vtkSmartPointer<vtkPolyData> dealtPoints(vtkDataSet* queries)
{
  const auto all = static_cast<vtkIdType>(
    parallel::sum(parallel::isFirst() ? static_cast<double>(queries->GetNumberOfPoints()) : 0));
  const vtkIdType own = endOfDeal(all, parallel::rank()) - startOfDeal(all, parallel::rank());
  vtkNew<vtkDoubleArray> positions;
  positions->SetNumberOfComponents(3);
  parallel::agree([&] { positions->SetNumberOfTuples(own); });
  constexpr std::size_t bytesOfPoint = 3 * sizeof(double);
  if (!parallel::isFirst())
  {
    parallel::receive(positions->GetPointer(0), static_cast<std::size_t>(own) * bytesOfPoint, 0);
  }
  std::vector<double> round;
  for (int rank = 0; parallel::isFirst() && rank < parallel::count(); ++rank)
  {
    const vtkIdType start = startOfDeal(all, rank), end = endOfDeal(all, rank);
    round.resize(3 * static_cast<std::size_t>(end - start));
    double* const to = rank == 0 ? positions->GetPointer(0) : round.data();
    for (vtkIdType i = start; i < end; ++i)
    {
      queries->GetPoint(i, to + 3 * (i - start));
    }
    if (rank > 0)
    {
      parallel::send(round.data(), round.size() * sizeof(double), rank);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/// The values of all ranks, rank by rank; null on all ranks but the first.
vtkSmartPointer<vtkDataArray> gathered(vtkDataArray* own, vtkIdType all)
{
  const auto bytesOfValue = static_cast<std::size_t>(own->GetDataTypeSize());
  const auto bytesOf = [=](vtkIdType values)
  {
    return static_cast<std::size_t>(values) * bytesOfValue;
  };
  if (!parallel::isFirst())
  {
    parallel::send(own->GetVoidPointer(0), bytesOf(own->GetNumberOfTuples()), 0);
    return nullptr;
  }
  auto values = vtkSmartPointer<vtkDataArray>::Take(own->NewInstance());
  values->SetName(own->GetName());
  values->SetNumberOfTuples(all);
  auto* const to = static_cast<unsigned char*>(values->GetVoidPointer(0));
  const auto* const from = static_cast<const unsigned char*>(own->GetVoidPointer(0));
  std::copy_n(from, bytesOf(own->GetNumberOfTuples()), to);
  for (int rank = 1; rank < parallel::count(); ++rank)
  {
    const vtkIdType start = startOfDeal(all, rank);
    parallel::receive(to + bytesOf(start), bytesOf(endOfDeal(all, rank) - start), rank);
  }
  return values;
}

ProbeAnswer dealtAnswer(
  vtkWindingNumberProbe& probe, vtkDataSet* queries, const Options& options, Messages& messages)
{
  const vtkSmartPointer<vtkPolyData> own = dealtPoints(queries);
  probe.SetInputDataObject(own);
  execute(probe, options, messages);
  vtkDataSet* const part = probe.GetOutput();
  ProbeAnswer answer;
  if (parallel::isFirst())
  {
    answer.data = vtkSmartPointer<vtkDataSet>::Take(queries->NewInstance());
    answer.data->ShallowCopy(queries);
    for (int i = 0; i < part->GetFieldData()->GetNumberOfArrays(); ++i)
    {
      answer.data->GetFieldData()->AddArray(part->GetFieldData()->GetAbstractArray(i));
    }
  }
  for (int i = 0; i < part->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const values = part->GetPointData()->GetArray(i);
    if (const auto all = gathered(values, queries->GetNumberOfPoints()))
    {
      answer.data->GetPointData()->AddArray(all);
      answer.data->GetPointData()->SetActiveScalars(all->GetName());
      if (std::string(all->GetName()) == "Inside")
      {
        const auto* const flags = static_cast<const unsigned char*>(all->GetVoidPointer(0));
        answer.inside.assign(flags, flags + all->GetNumberOfTuples());
      }
    }
  }
  return answer;
}

} // namespace

ProbeAnswer probeOnAllRanks(
  vtkWindingNumberProbe& probe, vtkDataSet* queries, const Options& options, Messages& messages)
{
  if (!parallel::isAlone() && !probe.GetExtractInside() && !probe.GetGenerateFraction())
  {
    parallel::agreeOnFirst([&] { checkQueries(queries, options, messages); });
    return dealtAnswer(probe, queries, options, messages);
  }
  vtkNew<vtkPolyData> none;
  probe.SetInputDataObject(parallel::isFirst() ? queries : none.Get());
  execute(probe, options, messages);
  ProbeAnswer answer;
  if (parallel::isFirst())
  {
    answer.data = probe.GetOutput();
    for (vtkIdType i = 0; i < queries->GetNumberOfPoints(); ++i)
    {
      answer.inside.push_back(probe.IsInside(i));
    }
  }
  return answer;
}
