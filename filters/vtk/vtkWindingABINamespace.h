// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The macros by which VTK puts its classes into a namespace of its build, where it has been asked
 * to. They came with VTK 9.3. Classes of the modules are in that namespace, too, and what declares
 * VTK's classes without their headers has to be.
 */
#ifndef vtkWindingABINamespace_h
#define vtkWindingABINamespace_h

#include "vtkCommonCoreModule.h" // includes vtkABINamespace.h from VTK 9.3 on

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
