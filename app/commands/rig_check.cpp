// facenav rig check: tests whether the calibration is still valid.

#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "commands/rig_steps.h"
#include "facenav/capture/calibration_images.h"
#include "facenav/capture/recording.h"
#include "facenav/core/log.h"
#include "facenav/health/verify_rig.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

using CheckJson = nlohmann::ordered_json;

constexpr int kMostFrames = 60;  // frames of a recording that are used

using FrameTaker = std::function<void(const cameras::StereoFrame&)>;

void takeFrames(capture::FrameSource& source, std::int64_t step, const FrameTaker& take) {
  for (std::int64_t i = 0; const auto frame = source.next(); ++i)
    if (i % step == 0) take(*frame);
}

void takeLive(const capture::NamedRig& rig, const RigRequest& request, const Context& context,
              const FrameTaker& take) {
  const auto source = capture::openRig(context.registrations.cameras, rig);
  std::optional<double> until_s, next_s;
  while (const auto frame = source->next()) {
    if (!until_s) until_s = frame->captured.s + request.live_s;
    if (frame->captured.s > *until_s) break;
    if (next_s && frame->captured.s < *next_s) continue;
    next_s = frame->captured.s + request.live_s / kMostFrames;
    take(*frame);
  }
  if (const auto missing = source->missingPairs(); !missing.empty()) logWarning(missing);
  for (const auto& words : capture::changedSettings(*source)) logWarning(words);
}

void takePictures(const RigRequest& request, const FrameTaker& take) {
  for (const auto& pair : capture::readCalibrationImages(request.left, request.right))
    take({pair.left, pair.right, 0, {}});
}

void takeAll(const capture::NamedRig& rig, const RigRequest& request, const Context& context,
             const FrameTaker& take) {
  const int sources = int(!request.recording.empty()) + int(!request.left.empty() && !request.right.empty()) +
                      int(request.live_s > 0);
  if (sources != 1)
    throw WrongUsage("it is not said what to check the rig with",
                     "give a recording, or --left and --right pictures, or --live");
  if (request.live_s > 0) return takeLive(rig, request, context, take);
  if (request.recording.empty()) return takePictures(request, take);
  const auto recording = capture::openRecording(request.recording);
  takeFrames(*capture::makeSource(recording), std::max<std::int64_t>(1, recording.frame_count / kMostFrames),
             take);
}

std::string checkJson(const health::RigVerification& result) {
  CheckJson lengths = CheckJson::array();
  for (const auto& length : result.lengths)
    lengths.push_back({{"what", length.what},
                       {"true_mm", length.true_mm},
                       {"measured_mm", length.measured_mm},
                       {"sigma_mm", length.sigma_mm}});
  const CheckJson json = {
      {"state", health::toString(result.state)},
      {"words", result.words()},
      {"frames", result.frames},
      {"board_frames", result.board_frames},
      {"marker_frames", result.marker_frames},
      {"lengths", lengths},
      {"row_error_px", result.row_error_px},
      {"left_lens_px", result.left_lens_px},
      {"right_lens_px", result.right_lens_px},
      {"scale_change", result.scale_change},
      {"turn_deg", result.turn_deg},
      {"shift_mm", result.shift_mm},
      {"point_error_mm", result.point_error_mm},
      {"fitting_square_mm", result.square_doubt ? CheckJson(result.square_doubt->fitting_mm) : CheckJson()}};
  return json.dump(1, ' ', false, CheckJson::error_handler_t::replace);
}

}  // namespace

void checkRig(const RigRequest& request, Context& context) {
  const capture::RigStore store(request.rigs);
  const capture::NamedRig rig = store.read(request.name);
  const auto coil =
      request.coil.empty() ? coil_tracking::defaultCoil() : coil_tracking::readCoil(request.coil);
  const auto& trackers = context.registrations.coil_trackers;
  health::RigVerifier verifier(
      rig.rig, boardOf(request),
      coil_tracking::squareFinder(trackers.create(trackers.defaultName()), rig.rig, coil));
  takeAll(rig, request, context, [&](const cameras::StereoFrame& frame) { verifier.add(frame); });
  const health::RigVerification result = verifier.result();
  store.note(request.name, {rigUtcNow(), health::toString(result.state), result.words()});
  if (request.is_json) {
    std::printf("%s\n", checkJson(result).c_str());
  } else {
    for (const auto& line : result.findings()) std::printf("%s\n", line.c_str());
    if (result.state == health::RigState::holds)
      std::printf("%s: %s\n", request.name.c_str(), result.words().c_str());
  }
  if (result.state == health::RigState::holds) return;
  const bool has_no_board = request.board.empty() && result.marker_frames == 0;
  throw Error(request.name + ": " + result.words(), {},
              has_no_board ? "to check with a board, give --board and --square" : "");
}

}  // namespace facenav::app
