#pragma once

#include "commands/Slabs.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;

/**
 * The image of a whole grid on the first rank, put together of slabs without a layer in common
 * (Slabs.h): the n-th is the image of rank n, whose own is null where there are fewer slabs. The
 * other ranks get null. Throws Failure where the whole does not fit into memory. Collective.
 */
vtkSmartPointer<vtkImageData> gatheredImage(
  vtkImageData* own, const std::vector<SlabExtent>& slabs);
