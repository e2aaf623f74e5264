#pragma once

/**
 * @file
 * What differs between the VTK versions that this project builds with (9.1 and newer), in one
 * place.
 */
namespace winding
{

/// Whether a filter was told to stop. vtkAlgorithm::CheckAbort came between VTK 9.2 and 9.3; where
/// it exists, it also asks the filters downstream.
template <class Algorithm> auto isAborted(Algorithm* filter, int) -> decltype(filter->CheckAbort())
{
  return filter->CheckAbort();
}

template <class Algorithm> bool isAborted(Algorithm* filter, long)
{
  return filter->GetAbortExecute() != 0;
}

template <class Algorithm> bool isAborted(Algorithm* filter)
{
  return isAborted(filter, 0) || filter->GetAbortExecute() != 0;
}

} // namespace winding
