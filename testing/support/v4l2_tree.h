#pragma once
// Cameras as /sys and /proc show them, over the fake kernel (fake_v4l2.h).

#include <filesystem>
#include <fstream>

#include "facenav/capture/camera_backend.h"
#include "support/fake_v4l2.h"
#include "support/test_data.h"

namespace facenav::testing {

class V4l2Tree {
 public:
  /// Adds a camera. `index`: "0" gives pictures, others carry metadata.
  void add(const std::string& video, const std::string& model, const std::string& port,
           const std::string& serial, const std::string& index = "0") {
    namespace fs = std::filesystem;
    const fs::path usb = root() / "devices" / port, interface = usb / (port + ":1.0"),
                   entry = root() / "sys" / video;
    fs::create_directories(interface);
    fs::create_directories(entry);
    std::ofstream(usb / "idVendor") << "046d\n";
    if (!serial.empty()) std::ofstream(usb / "serial") << serial << "\n";
    std::ofstream(entry / "name") << model << "\n";
    std::ofstream(entry / "index") << index << "\n";
    fs::create_directory_symlink(interface, entry / "device");
    if (index == "0") kernel().cameras["/dev/" + video] = std::make_shared<FakeV4l2Camera>();
  }
  /// Marks it as opened and streaming by another program.
  void use(const std::string& video, const std::string& program, const std::string& process) {
    kernel().cameras["/dev/" + video]->is_busy = true;
    std::filesystem::create_directories(root() / "proc" / process / "fd");
    std::ofstream(root() / "proc" / process / "comm") << program << "\n";
    std::filesystem::create_symlink("/dev/" + video, root() / "proc" / process / "fd" / "7");
  }
  std::vector<capture::FoundCamera> list() const {
    capture::CameraBackends backends("camera connection");
    backends.add("v4l2", "", [this] {
      return capture::makeV4l2Backend(kernel_, {root() / "sys", "/dev", root() / "proc"});
    });
    return capture::listCameras(backends);
  }
  std::filesystem::path root() const { return folder_.path(); }
  FakeV4l2& kernel() const { return *kernel_; }

 private:
  TemporaryFolder folder_;
  std::shared_ptr<FakeV4l2> kernel_ = std::make_shared<FakeV4l2>();
};

}  // namespace facenav::testing
