#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

struct zip;

/// The files of a .zip. Throws Failure for an archive that is damaged.
class ZipArchive
{
public:
  explicit ZipArchive(const std::string& fileName);

  /// Returns whether there is a file of this name, in small letters or capitals.
  bool has(const std::string& name) const;

  /// Hands on the bytes of a file, in parts. Throws Failure where there is none of that name.
  void read(const std::string& name, const std::function<void(std::string_view)>& take) const;

private:
  std::string fileName_;
  std::unique_ptr<zip, void (*)(zip*)> archive_;
};
