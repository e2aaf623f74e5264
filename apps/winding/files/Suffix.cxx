#include "files/Suffix.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

std::string suffixOf(const std::string& fileName)
{
  std::string suffix = std::filesystem::path(fileName).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

bool isTable(const std::string& fileName)
{
  const std::string suffix = suffixOf(fileName);
  return suffix == ".csv" || suffix == ".tsv";
}
