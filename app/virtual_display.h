#pragma once
// VTK on this platform renders through GLX and needs an X display. VirtualDisplay starts a private Xvfb for
// its lifetime.

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
