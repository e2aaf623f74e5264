// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMPIController.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <memory>

/// Runs the tests on all ranks at once. Each rank checks its own results; only the first rank tells
/// of tests that pass.
int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  testing::InitGoogleTest(&argc, argv);
  if (controller->GetLocalProcessId() > 0)
  {
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    testing::TestEventListener* printer = listeners.Release(listeners.default_result_printer());
    /// Tells of failures alone.
    class Failures final : public testing::EmptyTestEventListener
    {
    public:
      explicit Failures(testing::TestEventListener* all)
        : all_(all)
      {
      }
      void OnTestPartResult(const testing::TestPartResult& result) override
      {
        all_->OnTestPartResult(result);
      }

    private:
      std::unique_ptr<testing::TestEventListener> all_;
    };
    listeners.Append(new Failures(printer));
  }
  const int status = RUN_ALL_TESTS();
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return status;
}
