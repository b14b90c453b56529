// facenav rig new: stores two cameras, their locked settings and their calibration under a name.

#include <cstdio>

#include "commands/picture_size.h"
#include "commands/rig_steps.h"
#include "facenav/cameras/calibrate.h"
#include "facenav/capture/calibration_images.h"
#include "facenav/core/log.h"
#include "facenav/setup/settle_camera.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

constexpr double kTrial_s = 1.0;  // duration of the trial of a pair

/// Reads the calibration from the given files; returns nothing if a live board is wanted.
std::optional<cameras::StereoRig> fromFilesOf(const RigRequest& request, Context& context) {
  if (!request.calibration.empty()) return cameras::readRig(request.calibration);
  const auto board = boardOf(request);
  const bool has_pictures = !request.left.empty() && !request.right.empty();
  if (board && !has_pictures && !request.left_camera.empty()) return std::nullopt;
  if (!board || !has_pictures)
    throw WrongUsage(
        "the calibration is missing",
        "give --calibration stereo.yml, or --board and --square with --left and --right pictures, or "
        "with --left-camera and --right-camera");
  const auto result = request.is_choosing
                          ? calibrateChosen(request, context)
                          : cameras::calibrate(capture::readCalibrationImages(request.left, request.right),
                                               *board, context.monitor);
  for (const auto& warning : result.warnings) logWarning(warning);
  return result.rig;
}

/// Adds both cameras, locked at settings that suit the light, in the size of `size`.
void addCamerasTo(capture::NamedRig& rig, const cameras::StereoRig& size, const RigRequest& request,
                  const Context& context) {
  const auto& backends = context.registrations.cameras;
  const auto found = capture::listCameras(backends);
  capture::CameraSettings settings = request.settings;
  settings.width_px = size.width_px;
  settings.height_px = size.height_px;
  rig.left = steps::settledCamera(backends, capture::findCamera(found, request.left_camera), settings);
  rig.right = steps::settledCamera(backends, capture::findCamera(found, request.right_camera), settings);
}

/// Tries the pair and prints its warnings.
void tryOut(const capture::NamedRig& rig, const Context& context) {
  const auto source = capture::openRig(context.registrations.cameras, rig);
  for (const double until_s = Timestamp::now().s + kTrial_s; Timestamp::now().s < until_s;)
    if (!source->next()) break;
  for (const auto& words : source->cautions()) logWarning(words);
}

void calibrateBefore(capture::NamedRig& rig, const RigRequest& request, Context& context) {
  rig.rig = sizeOnly(request.size);
  addCamerasTo(rig, rig.rig, request, context);
  const auto source = capture::openRig(context.registrations.cameras, rig);
  const auto result = calibrateLive(*source, request, context);
  for (const auto& warning : result.warnings) logWarning(warning);
  for (const auto& words : source->cautions()) logWarning(words);
  rig.rig = result.rig;
}

}  // namespace

void makeRig(const RigRequest& request, Context& context) {
  if (request.left_camera.empty() != request.right_camera.empty())
    throw WrongUsage("one of the two cameras is missing",
                     "give --left-camera and --right-camera, or neither");
  const capture::RigStore store(request.rigs);
  if (!request.is_replacing && std::filesystem::exists(store.folderOf(request.name)))
    throw Error("there is a rig of this name", store.folderOf(request.name).string(),
                "choose another, or give --replace");
  capture::NamedRig rig;
  rig.name = request.name;
  rig.created_utc = rigUtcNow();
  if (const auto known = fromFilesOf(request, context)) {
    rig.rig = *known;
    if (!request.left_camera.empty()) {
      addCamerasTo(rig, *known, request, context);
      tryOut(rig, context);
    }
  } else {
    calibrateBefore(rig, request, context);
  }
  rig.uncertainty = steps::uncertaintyAt(rig.rig, request.distance_mm);
  store.write(rig, request.is_replacing ? Existing::replace : Existing::refuse);
  std::printf("%s: %d x %d px, %.1f mm apart, %s: %s\n", rig.name.c_str(), rig.rig.width_px,
              rig.rig.height_px, rig.rig.baseline_mm(), uncertaintyInWords(rig).c_str(),
              store.folderOf(rig.name).c_str());
  if (!rig.left)
    logWarning(
        "the rig knows no cameras; with --left-camera and --right-camera it keeps which two, and their "
        "settings");
}

}  // namespace facenav::app
