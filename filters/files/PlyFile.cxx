#include "files/PlyFile.h"

#include "files/PlyBody.h"
#include "files/PlyHeader.h"

namespace winding
{

MeshArrays readPly(const InputFile& file, Executor& executor)
{
  const PlyHeader header = readPlyHeader(file);
  return header.encoding == PlyEncoding::text ? readPlyText(file, header, executor)
                                              : readPlyBinary(file, header, executor);
}

} // namespace winding
