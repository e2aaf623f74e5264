#include "files/PlyFile.h"

#include "files/PlyBody.h"
#include "files/PlyHeader.h"

namespace winding
{

MeshArrays readPly(const InputFile& file, Executor& executor)
{
  const PlyHeader header = readPlyHeader(file);
  MeshArrays mesh = header.encoding == PlyEncoding::text ? readPlyText(file, header, executor)
                                                         : readPlyBinary(file, header, executor);
  mesh.notes = header.notes;
  return mesh;
}

} // namespace winding
