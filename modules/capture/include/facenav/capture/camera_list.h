#pragma once
// Which cameras are plugged in, as the system names them (Linux: Video4Linux's entries below /sys).

#include <filesystem>
#include <string>
#include <vector>

namespace facenav::capture {

struct CameraDevice {
  int index = 0;     // of /dev/video<index>: what openCameraPair takes
  std::string name;  // "HD Pro Webcam C920"
};

/// In the order of their indices; only devices that give pictures (a camera's further entries hold its meta
/// data). Empty where there is none.
std::vector<CameraDevice> listCameras(const std::filesystem::path& entries = "/sys/class/video4linux");

}  // namespace facenav::capture
