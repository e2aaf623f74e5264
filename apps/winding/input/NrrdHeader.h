#pragma once

#include "input/ImagePlace.h"

#include <string>

/// Reads the header of a NRRD (.nrrd, .nhdr), whose lengths are mm. Its space is the one that it
/// names, or else LPS, as in ITK. Throws HeaderFault.
ImagePlace nrrdImage(const std::string& head);
