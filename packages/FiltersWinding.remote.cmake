# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# For VTK's folder Remote: -D VTK_MODULE_ENABLE_VTK_FiltersWinding=YES has VTK clone the repository,
# and -D VTK_MODULE_ENABLE_Winding_IOWinding=YES build both modules along with its own;
# Winding_FiltersWinding builds the filters alone. WINDING_REPOSITORY is where the repository is
# cloned from. Highway, Eigen and nanoflann have to be installed. The test
# install.module_tree_configures reads this file.
vtk_fetch_module(FiltersWinding
  "Winding-number fields of surfaces and oriented point clouds"
  GIT_REPOSITORY "${WINDING_REPOSITORY}"
  GIT_TAG "${WINDING_TAG}")
