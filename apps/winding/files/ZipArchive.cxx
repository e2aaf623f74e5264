#include "files/ZipArchive.h"

#include "program/Failure.h"

#include <zip.h>

ZipArchive::ZipArchive(const std::string& fileName)
  : fileName_(fileName)
  , archive_(zip_open(fileName.c_str(), ZIP_RDONLY, nullptr), zip_discard)
{
  if (!archive_)
  {
    throw Failure(EXIT_REFUSED, fileName_, "is no whole zip archive; it is cut off or damaged");
  }
}

bool ZipArchive::has(const std::string& name) const
{
  return zip_name_locate(archive_.get(), name.c_str(), ZIP_FL_NOCASE) >= 0;
}

void ZipArchive::read(
  const std::string& name, const std::function<void(std::string_view)>& take) const
{
  if (!this->has(name))
  {
    throw Failure(EXIT_REFUSED, fileName_, "has no " + name + " in it; it is damaged");
  }
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
    zip_fopen(archive_.get(), name.c_str(), ZIP_FL_NOCASE), zip_fclose);
  char bytes[1 << 16];
  zip_int64_t count = -1;
  while (file && (count = zip_fread(file.get(), bytes, sizeof bytes)) > 0)
  {
    take(std::string_view(bytes, static_cast<std::size_t>(count)));
  }
  if (count < 0) // of its sum, too
  {
    throw Failure(EXIT_REFUSED, fileName_,
      "its " + name + " cannot be unpacked; it is damaged or has a password");
  }
}
