#pragma once
// Lists the connected cameras with the system's names for them (Linux: Video4Linux's entries below /sys).

#include <filesystem>
#include <string>
#include <vector>

namespace facenav::capture {

struct CameraDevice {
  int index = 0;     // of /dev/video<index>; input of openCameraPair
  std::string name;  // "HD Pro Webcam C920"
};

/// In the order of their indices. Only devices that deliver pictures; a camera's other entries hold its
/// metadata. Empty if there is none.
std::vector<CameraDevice> listCameras(const std::filesystem::path& entries = "/sys/class/video4linux");

}  // namespace facenav::capture
