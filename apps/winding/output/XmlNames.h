// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

/// Text for an attribute of XML.
std::string escapedForXml(const std::string& text);

/**
 * Gives the arrays of a data set names, and names of components, that come back as they were when
 * an XML file of VTK is read: the writers of VTK 9.1 to 9.7 put them between quotation marks as
 * they are, and a quotation mark or a "<" in one makes a file that nobody can read. Control
 * characters, which XML cannot hold, become question marks; bytes that are no UTF-8 are taken for
 * Latin-1.
 */
void prepareNamesForXml(vtkDataSet* data);
