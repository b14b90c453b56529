#pragma once
// VTK on this platform renders through GLX and needs an X display. VirtualDisplay gives a program without one
// a private Xvfb for as long as the object lives.

#include <string>

namespace facenav::app {

class VirtualDisplay {
 public:
  /// Starts Xvfb and sets DISPLAY. Throws Error when Xvfb is not installed or does not start within 10 s.
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

 private:
  int process_ = -1;
};

}  // namespace facenav::app
