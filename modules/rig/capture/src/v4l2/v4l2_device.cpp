#include "v4l2_device.h"

#include <linux/videodev2.h>

#include <cerrno>
#include <cstring>

namespace facenav::capture {
namespace {

struct FaultWords {
  CameraFault fault;
  const char *what, *remedy;  // what: null for the caller's text
};

FaultWords wordsOfError(int error) {
  switch (error) {
    case EBUSY:
      return {CameraFault::in_use, "the camera is in use by another program",
              "close that program and try again"};
    case EACCES:
    case EPERM:
      return {CameraFault::no_permission, "this user may not open the camera",
              "ask your administrator to add this user to the group 'video', then log in again"};
    case ENODEV:
    case ENXIO:
      return {CameraFault::unplugged, "the camera was unplugged",
              "check the cable and open the cameras again"};
    case ENOENT:
      return {CameraFault::missing, "there is no such camera", "plug it in and look again"};
    case ENOSPC:
      return {CameraFault::no_bandwidth, "the USB connection cannot carry this camera's pictures as well",
              "plug the two cameras into different USB controllers, or choose the format MJPG"};
    default:
      return {CameraFault::refused, nullptr, "unplug the camera, plug it in again and try again"};
  }
}

}  // namespace

V4l2Device::V4l2Device(std::shared_ptr<V4l2Driver> driver, const CameraIdentity& camera)
    : driver_(std::move(driver)), where_(inWords(camera)), device_(driver_->open(camera.address)) {
  if (device_ < 0) fail(-device_, "the camera cannot be opened");
  try {
    requirePictures();
  } catch (...) {
    driver_->close(device_);
    throw;
  }
}

V4l2Device::~V4l2Device() { driver_->close(device_); }

void V4l2Device::requirePictures() {
  v4l2_capability capability = {};
  require(VIDIOC_QUERYCAP, &capability, "this is no Video4Linux camera");
  const auto caps =
      capability.capabilities & V4L2_CAP_DEVICE_CAPS ? capability.device_caps : capability.capabilities;
  if (!(caps & V4L2_CAP_VIDEO_CAPTURE) || !(caps & V4L2_CAP_STREAMING))
    throw CameraError(CameraFault::refused, "this device takes no pictures", where_, "choose another camera");
}

void V4l2Device::require(unsigned long request, void* argument, const std::string& what) {
  const int result = ask(request, argument);
  if (result < 0) fail(-result, what);
}

void V4l2Device::fail(int error, const std::string& what) const {
  const FaultWords words = wordsOfError(error);
  throw CameraError(words.fault, words.what ? words.what : what + " (" + std::strerror(error) + ")", where_,
                    words.remedy);
}

}  // namespace facenav::capture
