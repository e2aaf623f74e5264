#include "files/Suffix.h"

#include "files/TextScanning.h"

#include <filesystem>

std::string suffixOf(const std::string& fileName)
{
  return inSmallLetters(std::filesystem::path(fileName).extension().string());
}

bool isTable(const std::string& fileName)
{
  const std::string suffix = suffixOf(fileName);
  return suffix == ".csv" || suffix == ".tsv";
}

char separatorOf(const std::string& fileName)
{
  return suffixOf(fileName) == ".tsv" ? '\t' : ',';
}
