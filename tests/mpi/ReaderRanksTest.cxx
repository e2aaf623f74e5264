// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/TemporaryFile.h"
#include "mpi/OnRanks.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>

/**
 * @file
 * Readers in a parallel program. Their library has a number of ranks of its own.
 */

using namespace onranks;

TEST(ReaderOnRanks, SharesTheCoresOfItsHost)
{
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  if (threads < 2)
  {
    GTEST_SKIP() << "there are no cores to share";
  }
  // A filter counts the ranks of this machine, and the reader asks the filters.
  const auto field =
    filterOf<vtkWindingNumberField>(partOf(shapes::icosphere(1), whole, rank(), ranks()), false);
  field->SetResolution(5);
  updatePiece(field);

  std::string points = "x,y,z\n";
  for (int i = 0; i < 100000; ++i)
  {
    points += std::to_string(i) + ".25,0.5,1.75\n";
  }
  const TemporaryFile file(points, ".csv");
  vtkNew<vtkWindingNumberReader> reader;
  reader->SetFileName(file.name());
  int least = threads; // the first and the last event come from the executive
  vtkNew<vtkCallbackCommand> look;
  look->SetClientData(&least);
  look->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      int& seen = *static_cast<int*>(data);
      seen = std::min(seen, vtkSMPTools::GetEstimatedNumberOfThreads());
    });
  reader->AddObserver(vtkCommand::ProgressEvent, look);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 100000);
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  EXPECT_EQ(least, ranks() == 1 ? threads : std::clamp(cores / ranks(), 1, threads));
}
