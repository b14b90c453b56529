#include "facenav/capture/camera.h"

namespace facenav::capture {

std::string stableName(const CameraIdentity& camera) {
  if (!camera.serial.empty()) return camera.backend + ":" + camera.model + "#" + camera.serial;
  if (!camera.port.empty()) return camera.backend + ":" + camera.model + "@" + camera.port;
  return camera.backend + ":" + camera.address;
}

bool isSameCamera(const CameraIdentity& a, const CameraIdentity& b) { return stableName(a) == stableName(b); }

std::string inWords(const CameraIdentity& camera) {
  std::string words = camera.model.empty() ? camera.backend + " camera" : camera.model;
  if (!camera.serial.empty())
    words += ", serial number " + camera.serial;
  else if (!camera.port.empty())
    words += ", port " + camera.port;
  return words + " (" + camera.address + ")";
}

std::vector<std::string> unlockedInWords(const CameraState& state) {
  std::vector<std::string> words;
  for (const ControlState& control : state.controls)
    if (control.lock == ControlState::Lock::refused) words.push_back(control.name + ": " + control.words);
  return words;
}

}  // namespace facenav::capture
