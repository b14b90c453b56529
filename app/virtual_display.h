#pragma once
// VTK on this platform renders through GLX and needs an X display. VirtualDisplay gives a program without one
// a private Xvfb for as long as the object lives.

#include <memory>

#include "facenav/core/child_process.h"

namespace facenav::app {

class VirtualDisplay {
 public:
  /// Starts Xvfb and sets DISPLAY. Throws Error when Xvfb is not installed or does not start within 10 s.
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

 private:
  std::unique_ptr<ChildProcess> xvfb_;
};

}  // namespace facenav::app
