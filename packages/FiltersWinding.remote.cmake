# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# For VTK's folder Remote: has VTK build the module of filters along with its own, by
# -D Module_FiltersWinding=ON, and with -D VTK_MODULE_ENABLE_Winding_IOWinding=YES the readers, too.
# WINDING_REPOSITORY is where the repository is cloned from. Highway, Eigen and nanoflann have to be
# installed. The test install.module_tree_configures reads this file.
vtk_fetch_module(FiltersWinding
  "Winding-number fields of surfaces and oriented point clouds"
  GIT_REPOSITORY "${WINDING_REPOSITORY}"
  GIT_TAG "${WINDING_TAG}")
