// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/Messages.h"

#include "program/Failure.h"
#include "program/Progress.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <iostream>

vtkStandardNewMacro(Messages);

namespace
{

/// Makes "message", on one line, of "ERROR: In file, line 1\nvtkFoo (0x1): message\n\n".
std::string undecorated(const std::string& text)
{
  std::size_t start = 0;
  if (text.rfind("ERROR: In ", 0) == 0 || text.rfind("Warning: In ", 0) == 0 ||
      text.rfind("Generic Warning: In ", 0) == 0)
  {
    start = std::min(text.find('\n'), text.size());
    const std::size_t address = text.find(" (0x", start);
    const std::size_t close = text.find("): ", start);
    if (address != std::string::npos && close != std::string::npos && address < close &&
        text.find('\n', start + 1) > close)
    {
      start = close + 3;
    }
  }
  std::string line;
  for (std::size_t i = start; i < text.size(); ++i)
  {
    const bool isSpace = text[i] == ' ' || text[i] == '\n' || text[i] == '\t' || text[i] == '\r';
    if (!isSpace)
    {
      line += text[i];
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

/// Whether this is the line that a pipeline adds after an algorithm in it has failed and said why.
bool isEcho(const std::string& line)
{
  return line.find("returned failure for request") != std::string::npos;
}

/// A message that is undecorated, with the name of the file before it unless it stands there.
std::string about(const std::string& file, const std::string& message)
{
  const bool isNamed = message.rfind(undecorated(file) + ':', 0) == 0;
  return isNamed || file.empty() ? message : file + ": " + message;
}

} // namespace

Messages& Messages::install(bool quiet)
{
  vtkNew<Messages> messages;
  messages->quiet_ = quiet;
  vtkOutputWindow::SetInstance(messages);
  // VTK's logger would print the same once more, in its own way.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  return *messages;
}

void Messages::setSubject(const std::string& file)
{
  subject_ = file;
}

void Messages::throwIfError(const std::string& file)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!error_.empty())
  {
    const std::string error = about(file, error_);
    error_.clear();
    throw Failure(EXIT_REFUSED, error);
  }
}

void Messages::warn(const std::string& text)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!quiet_ && printed_.insert(text).second)
  {
    printLine("winding: warning: " + text);
  }
}

void Messages::DisplayText(const char* text)
{
  this->DisplayWarningText(text);
}

void Messages::DisplayErrorText(const char* text)
{
  const std::string line = undecorated(text);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (error_.empty() && !line.empty())
  {
    error_ = isEcho(line) ? "VTK failed without saying why" : line;
  }
}

void Messages::DisplayWarningText(const char* text)
{
  this->warn(about(subject_, undecorated(text)));
}

void Messages::DisplayGenericWarningText(const char* text)
{
  this->DisplayWarningText(text);
}

void printLine(const std::string& line)
{
  Progress::clear();
  std::string shown = line;
  // Names and contents of files may hold any characters, which are not to control the terminal.
  std::replace_if(
    shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  std::cerr << shown << std::endl;
}

std::string outOfMemoryAdvice()
{
  return "not enough memory; choose a coarser grid (--resolution, --voxel-size, --dims) or "
         "--pieces";
}
