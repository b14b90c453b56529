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

/// Options of new, check and list.
struct RigRequest {
  std::string name, board, left_camera, right_camera;
  std::filesystem::path rigs, calibration, recording, coil, page;
  double square_mm = 0, distance_mm = 600, live_s = 0, within_s = 300;
  std::string size = "1280x720";  // size of live pictures of the board
  bool is_choosing = false;
  std::vector<std::string> left, right;
  capture::CameraSettings settings;
  bool is_json = false, is_replacing = false;
};

/// Current time, ISO 8601.
std::string rigUtcNow();
/// Board of --board and --square; nothing without --board. Throws Error if --square is missing.
std::optional<cameras::Board> boardOf(const RigRequest& request);
/// Formats the uncertainty: "+-0.42 mm at 600 mm".
std::string uncertaintyInWords(const capture::NamedRig& rig);

/// Calibrates with a board that a person holds before live cameras, with prompts on the terminal. Uses only
/// pictures that show something new.
cameras::Calibration calibrateLive(capture::FrameSource& source, const RigRequest& request, Context& context);
cameras::Calibration calibrateChosen(const RigRequest& request, Context& context);
void makeRig(const RigRequest& request, Context& context);
/// Checks the rig. Throws Error with the verdict unless the calibration is still valid.
void checkRig(const RigRequest& request, Context& context);
void listRigs(const RigRequest& request);

}  // namespace facenav::app
