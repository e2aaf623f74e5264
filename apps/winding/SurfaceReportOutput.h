#pragma once

class FieldRun;
struct Options;
class vtkPolyData;

/// Prints what a run has made: the report of its field, and the surface that was written.
void printSurfaceReport(FieldRun& run, vtkPolyData* surface, const Options& options);
