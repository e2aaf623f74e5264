#pragma once

#include "program/Print.h"

#include <string>

class vtkPolyData;

/// How near a surface is to the input, from the arrays of FidelitySamples
/// (vtkWindingNumberSurface.h); null if the surface has none.
Json describeFidelity(vtkPolyData* surface);

/// The same, which is not null, in a line for people.
std::string fidelityInWords(const Json& fidelity);
