#include "facenav/capture/camera_backend.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "facenav/capture/stream_logins.h"
#include "facenav/core/shown_address.h"

namespace facenav::capture {
namespace {

using ModelAndSerial = std::tuple<std::string, std::string, std::string>;

ModelAndSerial modelAndSerial(const CameraIdentity& camera) {
  return {camera.backend, camera.model, camera.serial};
}

// Removes serial numbers that cheap cameras share among all units.
void removeSharedSerials(std::vector<FoundCamera>& found) {
  std::map<ModelAndSerial, int> count;
  for (const auto& camera : found) ++count[modelAndSerial(camera.identity)];
  for (auto& camera : found)
    if (count[modelAndSerial(camera.identity)] > 1) camera.identity.serial.clear();
}

bool isNamed(const CameraIdentity& camera, const std::string& text) {
  const std::string file = std::filesystem::path(camera.address).filename();
  return text == stableName(camera) || text == camera.address ||
         (!camera.serial.empty() && text == camera.serial) || text == file ||
         (camera.backend == "v4l2" && "video" + text == file);
}

bool isStreamAddress(const std::string& text) {
  std::error_code ignored;
  return text.find("://") != std::string::npos || std::filesystem::is_regular_file(text, ignored) ||
         std::filesystem::is_directory(text, ignored);
}

/// Address without the prefix of a stream's stable name, or of a file's URL.
std::string plainAddress(const std::string& text) {
  for (const std::string prefix : {"stream:", "file://"})
    if (text.rfind(prefix, 0) == 0) return plainAddress(text.substr(prefix.size()));
  return text;
}

/// What was typed, without a password: also where the scheme is missing, "doe:secret@host/left".
std::string asShown(const std::string& text) {
  static const std::string kAnyScheme = "rtsp://";
  for (const std::string backend : {"v4l2:", "genicam:", "dc1394:"})
    if (text.rfind(backend, 0) == 0) return text;
  const bool has_scheme = text.find("://") != std::string::npos;
  return has_scheme ? shownAddress(text) : shownAddress(kAnyScheme + text).substr(kAnyScheme.size());
}

bool looksLikePath(const std::string& text) {
  return text.find('/') != std::string::npos && text.rfind("/dev/", 0) != 0;
}

std::string whatIsThere(const std::vector<FoundCamera>& found) {
  if (found.empty()) return "no camera is connected; plug it in";
  std::string words = "connected: ";
  for (const auto& camera : found)
    words += (&camera == &found.front() ? "" : "; ") + inWords(camera.identity);
  return words;
}

CameraError missing(const std::string& what, const std::string& where, const std::string& remedy) {
  return CameraError(CameraFault::missing, what, where, remedy);
}

bool isSameModel(const CameraIdentity& a, const CameraIdentity& b) {
  return a.backend == b.backend && a.model == b.model && !a.model.empty();
}

/// Two equal cameras that differ only in their port.
const FoundCamera* twinWithoutSerial(const std::vector<FoundCamera>& found) {
  for (const auto& a : found)
    for (const auto& b : found)
      if (&a < &b && isSameModel(a.identity, b.identity) && a.identity.serial.empty() &&
          b.identity.serial.empty())
        return &a;
  return nullptr;
}

std::string useInWords(const FoundCamera& camera) {
  switch (camera.use) {
    case FoundCamera::Use::free:
      return "";
    case FoundCamera::Use::in_use:
      return "in use by " + (camera.user.empty() ? "another program" : camera.user);
    case FoundCamera::Use::no_permission:
      return "this user may not open it";
    case FoundCamera::Use::no_answer:
      return "it does not answer";
  }
  return "";
}

std::string remedyOf(FoundCamera::Use use) {
  if (use == FoundCamera::Use::in_use) return "close that program and look again";
  if (use == FoundCamera::Use::no_permission)
    return "ask your administrator to add this user to the group 'video', then log in again";
  return "unplug it, plug it in again and look again";
}

}  // namespace

std::vector<FoundCamera> listCameras(const CameraBackends& backends, Search search) {
  std::vector<FoundCamera> all;
  for (const auto& entry : backends.entries()) {
    const auto backend = entry.factory();
    if (search == Search::quick && backend->isSlow()) continue;
    const auto found = backend->list();
    all.insert(all.end(), found.begin(), found.end());
  }
  removeSharedSerials(all);
  return all;
}

CameraIdentity findCamera(const std::vector<FoundCamera>& found, const std::string& typed) {
  const std::string text = plainAddress(typed);
  std::vector<const FoundCamera*> fitting;
  for (const auto& camera : found)
    if (isNamed(camera.identity, text)) fitting.push_back(&camera);
  if (fitting.size() == 1) return fitting.front()->identity;
  if (fitting.size() > 1)
    throw missing("several cameras are called so", asShown(text),
                  "give the address of one: " + whatIsThere(found));
  if (isStreamAddress(text)) return streamIdentity(text);
  if (looksLikePath(text))
    throw missing("there is no such file or folder", asShown(text),
                  "check its name, or type a camera's address");
  throw missing("there is no such camera", asShown(text), whatIsThere(found));
}

CameraIdentity findCamera(const std::vector<FoundCamera>& found, const CameraIdentity& wanted) {
  for (const auto& camera : found)
    if (isSameCamera(camera.identity, wanted)) return camera.identity;
  if (wanted.backend == "stream") return wanted;
  for (const auto& camera : found)
    if (isSameModel(camera.identity, wanted))
      throw missing(wanted.serial.empty() ? "an equal camera is connected, in another port"
                                          : "an equal camera is connected, another piece",
                    inWords(wanted) + "; connected: " + inWords(camera.identity),
                    wanted.serial.empty()
                        ? "plug it into its own port, or make the rig anew"
                        : "connect the rig's own camera, or calibrate and make the rig anew");
  throw missing("the camera is not connected", inWords(wanted), whatIsThere(found));
}

std::unique_ptr<Camera> openCamera(const CameraBackends& backends, const CameraIdentity& camera) {
  return backends.create(camera.backend)->open(camera);
}

std::vector<std::string> adviceOn(const std::vector<FoundCamera>& found) {
  if (found.empty()) return {"no camera found: plug two cameras in and look again"};
  std::vector<std::string> advice;
  if (found.size() == 1)
    advice.push_back("one camera only: two are needed; plug the other in and look again");
  for (const auto& camera : found)
    if (camera.use != FoundCamera::Use::free) advice.push_back(inWords(camera) + ": " + remedyOf(camera.use));
  if (const FoundCamera* twin = twinWithoutSerial(found))
    advice.push_back(
        "two equal cameras without serial numbers (" + twin->identity.model +
        "): only their ports tell them apart; mark cables and ports left and right, keep them so, "
        "and open the cameras");
  return advice;
}

std::string inWords(const FoundCamera& camera) {
  const std::string use = useInWords(camera);
  return inWords(camera.identity) + (use.empty() ? "" : ": " + use);
}

}  // namespace facenav::capture
