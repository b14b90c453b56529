#pragma once
// The steps of facenav rig: new, check, list.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "context.h"
#include "facenav/cameras/calibrate.h"
#include "facenav/capture/rig_store.h"

namespace facenav::app {

/// Options of all three.
struct RigRequest {
  std::string name, board, left_camera, right_camera;
  std::filesystem::path rigs, calibration, recording, coil, page;
  double square_mm = 0, distance_mm = 600, live_s = 0, within_s = 300;
  std::string size = "1280x720";  // of live pictures of the board
  bool is_choosing = false;
  std::vector<std::string> left, right;
  capture::CameraSettings settings;
  bool is_json = false, is_replacing = false;
};

/// Now, ISO 8601.
std::string rigUtcNow();
/// The board of --board and --square; none without --board. Throws Error: --square is missing.
std::optional<cameras::Board> boardOf(const RigRequest& request);
/// "+-0.42 mm at 600 mm".
std::string uncertaintyInWords(const capture::NamedRig& rig);

/// From a board that a person holds before live cameras, and tells on the terminal what to do next; from
/// those of many pictures that show something new.
cameras::Calibration calibrateLive(capture::FrameSource& source, const RigRequest& request, Context& context);
cameras::Calibration calibrateChosen(const RigRequest& request, Context& context);
void makeRig(const RigRequest& request, Context& context);
/// Throws Error with the verdict unless the calibration holds.
void checkRig(const RigRequest& request, Context& context);
void listRigs(const RigRequest& request);

}  // namespace facenav::app
