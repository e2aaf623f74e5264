#pragma once

#include <functional>

class Messages;
class OutputFile;
struct Options;
class vtkAlgorithmOutput;
class vtkPointSet;
class vtkPolyData;

/**
 * @file
 * Write to the output file, in the format of its suffix, and give it its name. Throw Failure when
 * that fails or the program is interrupted.
 */

/// An image (.vti), made and written in options.pieces pieces. check is called before the file gets
/// its name, and throws where the pieces could not be made.
void writeImage(vtkAlgorithmOutput* image, OutputFile& file, const Options& options,
  Messages& messages, const std::function<void()>& check);

/// A surface: .vtp .ply .stl .obj.
void writeSurface(
  vtkPolyData* surface, OutputFile& file, const Options& options, Messages& messages);

/// The answer of a probe: .vtp or .vtu.
void writePoints(vtkPointSet* points, OutputFile& file, const Options& options, Messages& messages);
