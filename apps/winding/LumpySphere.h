#pragma once

#include "Triangles.h"

/// A closed sphere of 2 n² triangles whose radius varies, without common points, as in a .stl file.
Triangles lumpySphere(int n);
