#include "output/CloudFile.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "output/OutputFile.h"
#include "output/WriteOutput.h"
#include "program/Interrupt.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

namespace
{

/// Calls write(tuple) for all tuples of an array, and looks for interruptions now and then.
template <class Write> void forEachTuple(vtkDataArray* array, const Write& write)
{
  constexpr vtkIdType tuplesPerLook = 65536;
  double tuple[3];
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, tuple);
    write(i, tuple);
    if (i % tuplesPerLook == 0)
    {
      interrupt::check();
    }
  }
}

/// Positions and normals, line by line.
void writeLines(vtkDataArray* positions, vtkDataArray* normals, std::ofstream& stream)
{
  forEachTuple(positions,
    [&](vtkIdType point, const double position[3])
    {
      double normal[3];
      normals->GetTuple(point, normal);
      stream << exact(position, ' ') << ' ' << exact(normal, ' ') << '\n';
    });
}

/// The number of points, all positions, then all normals.
void writeParts(vtkDataArray* positions, vtkDataArray* normals, std::ofstream& stream)
{
  stream << positions->GetNumberOfTuples() << '\n';
  for (vtkDataArray* part : {positions, normals})
  {
    forEachTuple(
      part, [&stream](vtkIdType, const double vector[3]) { stream << exact(vector, ' ') << '\n'; });
  }
}

void writeTable(vtkDataArray* positions, vtkDataArray* normals, vtkDataArray* areas, char separator,
  std::ofstream& stream)
{
  for (const char* name : {"x", "y", "z", "nx", "ny"})
  {
    stream << name << separator;
  }
  stream << "nz";
  if (areas)
  {
    stream << separator << "area";
  }
  stream << '\n';
  forEachTuple(positions,
    [&](vtkIdType point, const double position[3])
    {
      double normal[3];
      normals->GetTuple(point, normal);
      stream << exact(position, separator) << separator << exact(normal, separator);
      if (areas)
      {
        stream << separator << exact(areas->GetTuple1(point));
      }
      stream << '\n';
    });
}

bool isFloat(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT;
}

template <class Number> void append(std::string& bytes, Number number)
{
  char own[sizeof number];
  std::memcpy(own, &number, sizeof number);
  bytes.append(own, sizeof number);
}

void append(std::string& bytes, const double vector[3], bool asFloat)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (asFloat)
    {
      append(bytes, static_cast<float>(vector[axis]));
    }
    else
    {
      append(bytes, vector[axis]);
    }
  }
}

void writePly(vtkDataArray* positions, vtkDataArray* normals, std::ofstream& stream)
{
  const std::uint16_t one = 1;
  unsigned char firstByte;
  std::memcpy(&firstByte, &one, 1);
  stream << "ply\nformat binary_" << (firstByte == 1 ? "little" : "big")
         << "_endian 1.0\nelement vertex " << positions->GetNumberOfTuples() << '\n';
  for (const char* name : {"x", "y", "z"})
  {
    stream << "property " << (isFloat(positions) ? "float " : "double ") << name << '\n';
  }
  for (const char* name : {"nx", "ny", "nz"})
  {
    stream << "property " << (isFloat(normals) ? "float " : "double ") << name << '\n';
  }
  stream << "end_header\n";
  std::string bytes;
  forEachTuple(positions,
    [&](vtkIdType point, const double position[3])
    {
      double normal[3];
      normals->GetTuple(point, normal);
      bytes.clear();
      append(bytes, position, isFloat(positions));
      append(bytes, normal, isFloat(normals));
      stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
}

} // namespace

void writeCloud(vtkPolyData* cloud, OutputFile& file, Messages& messages)
{
  const std::string suffix = suffixOf(file.name());
  if (suffix == ".vtp" || suffix == ".vtu")
  {
    writePoints(cloud, file, messages);
    return;
  }
  vtkDataArray* const positions = cloud->GetPoints()->GetData();
  vtkDataArray* const normals = cloud->GetPointData()->GetNormals();
  std::ofstream stream(file.temporaryName(), std::ios::binary);
  if (suffix == ".ply")
  {
    writePly(positions, normals, stream);
  }
  else if (suffix == ".xyz")
  {
    writeLines(positions, normals, stream);
  }
  else if (suffix == ".pwn")
  {
    writeParts(positions, normals, stream);
  }
  else
  {
    writeTable(positions, normals, cloud->GetPointData()->GetArray("Area"),
      separatorOf(file.name()), stream);
  }
  stream.close();
  if (!stream)
  {
    file.refuseWriting();
  }
}
