// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSMPTools.h"

#include <string>

/// Calls work with the name of each backend of vtkSMPTools that this VTK has, which is active
/// meanwhile. The backend of before is active again in the end.
template <class Work> void onEachBackend(const Work& work)
{
  const std::string before = vtkSMPTools::GetBackend();
#ifdef __SANITIZE_THREAD__
  // TBB's library is not compiled with the sanitizer, which so does not see that it waits.
  const char* const backends[] = {"Sequential", "STDThread"};
#else
  const char* const backends[] = {"Sequential", "STDThread", "TBB", "OpenMP"};
#endif
  for (const char* backend : backends)
  {
    if (vtkSMPTools::SetBackend(backend))
    {
      work(backend);
    }
  }
  vtkSMPTools::SetBackend(before.c_str());
}
