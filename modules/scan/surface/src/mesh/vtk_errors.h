#pragma once
// Catches VTK's errors, so that they become one Error instead of text on stderr. Private to surface.

#include <vtkCommand.h>

namespace facenav::surface {

class ErrorListener : public vtkCommand {
 public:
  static ErrorListener* New() { return new ErrorListener; }
  void Execute(vtkObject*, unsigned long, void*) override { has_error = true; }
  bool has_error = false;
};

}  // namespace facenav::surface
