#include <linux/videodev2.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>

#include "facenav/capture/v4l2_driver.h"
#include "v4l2_camera.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

std::string firstLineOf(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// Number of /dev/video<n>; -1: another device, or an entry for a camera's metadata.
int pictureDevice(const fs::path& entry) {
  const std::string name = entry.filename(), digits = name.substr(std::min<std::size_t>(5, name.size()));
  const bool is_video = name.rfind("video", 0) == 0 && !digits.empty() && digits.size() < 5 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
  return is_video && firstLineOf(entry / "index") == "0" ? std::stoi(digits) : -1;
}

/// Reads the USB port: the link `device` leads to the USB interface, "1-2.4:1.0"; its parent is the camera at
/// port 1-2.4.
void readUsb(const fs::path& entry, CameraIdentity& camera) {
  std::error_code ignored;
  const fs::path interface = fs::canonical(entry / "device", ignored);
  if (interface.empty()) return;
  const bool is_usb = fs::exists(interface.parent_path() / "idVendor", ignored);
  camera.port = (is_usb ? interface.parent_path() : interface).filename();
  if (is_usb) camera.serial = firstLineOf(interface.parent_path() / "serial");
}

bool hasOpen(const fs::path& process, const std::string& device) {
  std::error_code unreadable;
  for (const auto& file : fs::directory_iterator(process / "fd", unreadable)) {
    std::error_code gone;
    if (fs::read_symlink(file.path(), gone) == device) return true;
  }
  return false;
}

/// Process that has the device open: "cheese (process 4711)"; empty: not visible to this user.
std::string userOf(const std::string& device, const fs::path& proc) {
  std::error_code ignored;
  for (const auto& process : fs::directory_iterator(proc, ignored)) {
    const std::string number = process.path().filename();
    if (number.find_first_not_of("0123456789") == std::string::npos && hasOpen(process.path(), device))
      return firstLineOf(process.path() / "comm") + " (process " + number + ")";
  }
  return "";
}

class V4l2Backend : public CameraBackend {
 public:
  V4l2Backend(std::shared_ptr<V4l2Driver> driver, V4l2Places places)
      : driver_(std::move(driver)), places_(std::move(places)) {}
  std::vector<FoundCamera> list() override;
  std::unique_ptr<Camera> open(const CameraIdentity& camera) override {
    return openV4l2Camera(driver_, camera);
  }

 private:
  void readUse(FoundCamera& camera) const;
  std::shared_ptr<V4l2Driver> driver_;
  V4l2Places places_;
};

/// Detects whether a program streams: only that program may free the buffers, so a request to free them
/// (there are none) fails for others.
void V4l2Backend::readUse(FoundCamera& camera) const {
  const int device = driver_->open(camera.identity.address);
  v4l2_requestbuffers none = {};
  none.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  none.memory = V4L2_MEMORY_MMAP;
  const int answer = device < 0 ? device : driver_->control(device, VIDIOC_REQBUFS, &none);
  if (device >= 0) driver_->close(device);
  const bool is_ours = hasOpen(places_.proc / std::to_string(::getpid()), camera.identity.address);
  if (answer >= 0 || answer == -EINVAL || (answer == -EBUSY && is_ours)) return;
  camera.use = answer == -EBUSY                        ? FoundCamera::Use::in_use
               : answer == -EACCES || answer == -EPERM ? FoundCamera::Use::no_permission
                                                       : FoundCamera::Use::no_answer;
  if (camera.use == FoundCamera::Use::in_use) camera.user = userOf(camera.identity.address, places_.proc);
}

std::vector<FoundCamera> V4l2Backend::list() {
  std::vector<std::pair<int, FoundCamera>> numbered;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(places_.sys, ignored)) {
    const int number = pictureDevice(entry.path());
    if (number < 0) continue;
    FoundCamera camera;
    const std::string file = entry.path().filename(), model = firstLineOf(entry.path() / "name");
    camera.identity = {"v4l2", (places_.dev / file).string(), model.empty() ? file : model, "", ""};
    readUsb(entry.path(), camera.identity);
    readUse(camera);
    numbered.emplace_back(number, camera);
  }
  std::sort(numbered.begin(), numbered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<FoundCamera> found;
  for (auto& [number, camera] : numbered) found.push_back(std::move(camera));
  return found;
}

}  // namespace

std::unique_ptr<CameraBackend> makeV4l2Backend(std::shared_ptr<V4l2Driver> driver, const V4l2Places& places) {
  return std::make_unique<V4l2Backend>(std::move(driver), places);
}

std::unique_ptr<CameraBackend> makeV4l2Backend() { return makeV4l2Backend(makeSystemV4l2Driver(), {}); }

}  // namespace facenav::capture
