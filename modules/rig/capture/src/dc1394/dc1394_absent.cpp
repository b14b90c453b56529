// Replaces the IEEE 1394 backend if libdc1394 is not installed.
#include "facenav/capture/dc1394_driver.h"

namespace facenav::capture {
namespace {

class AbsentDc1394Backend : public CameraBackend {
 public:
  std::vector<FoundCamera> list() override { return {}; }
  std::unique_ptr<Camera> open(const CameraIdentity& camera) override {
    throw CameraError(CameraFault::refused, "this program was built without IEEE 1394 cameras",
                      inWords(camera), "install libdc1394-dev and build again");
  }
};

}  // namespace

std::unique_ptr<CameraBackend> makeDc1394Backend() { return std::make_unique<AbsentDc1394Backend>(); }

}  // namespace facenav::capture
