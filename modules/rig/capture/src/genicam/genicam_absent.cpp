// Replaces the GenICam backend if Aravis is not installed.
#include "facenav/capture/camera_backend.h"

namespace facenav::capture {
namespace {

class AbsentGenicamBackend : public CameraBackend {
 public:
  std::vector<FoundCamera> list() override { return {}; }
  std::unique_ptr<Camera> open(const CameraIdentity& camera) override {
    throw CameraError(CameraFault::refused, "this program was built without GenICam cameras", inWords(camera),
                      "install libaravis-dev and build again");
  }
};

}  // namespace

std::unique_ptr<CameraBackend> makeGenicamBackend() { return std::make_unique<AbsentGenicamBackend>(); }

}  // namespace facenav::capture
