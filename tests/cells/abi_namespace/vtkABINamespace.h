// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * VTK's header of this name as in a build of VTK with a namespace of its own.
 */
#ifndef vtkABINamespace_h
#define vtkABINamespace_h

#define VTK_HAS_ABI_NAMESPACE 1
#define VTK_ABI_NAMESPACE_NAME of_this_build
#define VTK_ABI_NAMESPACE_MANGLE(x) of_this_build_##x
#define VTK_ABI_NAMESPACE_BEGIN                                                                    \
  inline namespace of_this_build                                                                   \
  {
#define VTK_ABI_NAMESPACE_END }

#endif
