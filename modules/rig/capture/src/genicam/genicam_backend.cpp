#include "facenav/capture/camera_backend.h"
#include "genicam_call.h"
#include "genicam_camera.h"

namespace facenav::capture {
namespace {

std::string textOf(const char* text) { return text ? text : ""; }

CameraIdentity deviceIdentity(guint index) {
  const std::string vendor = textOf(arv_get_device_vendor(index)),
                    model = textOf(arv_get_device_model(index));
  return {"genicam", textOf(arv_get_device_id(index)), vendor.empty() ? model : vendor + " " + model,
          textOf(arv_get_device_serial_nbr(index)), textOf(arv_get_device_address(index))};
}

/// Opens a camera to find out whether another program has it: a camera obeys one program at a time.
void tryToOpen(FoundCamera& camera) {
  try {
    openGenicamCamera(camera.identity);
  } catch (const CameraError& error) {
    camera.use =
        error.fault() == CameraFault::in_use ? FoundCamera::Use::in_use : FoundCamera::Use::no_answer;
  }
}

class GenicamBackend : public CameraBackend {
 public:
  std::vector<FoundCamera> list() override {
    arv_update_device_list();
    std::vector<FoundCamera> found;
    for (guint i = 0; i < arv_get_n_devices(); ++i) {
      FoundCamera camera;
      camera.identity = deviceIdentity(i);
      found.push_back(std::move(camera));
    }
    for (FoundCamera& camera : found) tryToOpen(camera);
    return found;
  }
  std::unique_ptr<Camera> open(const CameraIdentity& camera) override { return openGenicamCamera(camera); }
  bool isSlow() const override { return true; }
};

}  // namespace

std::unique_ptr<CameraBackend> makeGenicamBackend() { return std::make_unique<GenicamBackend>(); }

}  // namespace facenav::capture
