#pragma once

#include <string>

class vtkObject;

/// Catches what a VTK object reports, instead of letting it go to standard error.
class ErrorLog
{
public:
  explicit ErrorLog(vtkObject* object);

  /// All errors, or all warnings, one after the other; empty if there were none.
  const std::string& errors() const { return errors_; }
  const std::string& warnings() const { return warnings_; }

private:
  std::string errors_, warnings_;
};
