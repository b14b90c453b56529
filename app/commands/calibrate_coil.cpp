// facenav calibrate-coil: pose of the contact face relative to the marker, from recordings -> coil.json.

#include <cstdio>

#include "commands/coil_option.h"
#include "commands/commands.h"
#include "facenav/capture/recording.h"
#include "facenav/coil_tracking/coil_calibration.h"
#include "facenav/core/utc_time.h"
#include "json_output.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

struct CalibrateCoilRequest {
  std::filesystem::path recording, jig, centre, handle, side, coil, output, library;
  std::string coil_words;
  bool is_json = false;
};

using MarkerPoses = std::vector<Tracked<coil_tracking::CoilPose>>;

/// Tracks all models; returns one entry per frame for each of them.
std::vector<MarkerPoses> trackMarkers(Context& context, const std::filesystem::path& folder,
                                      const std::vector<coil_tracking::CoilModel>& models) {
  const auto recording = capture::openRecording(folder);
  std::vector<std::unique_ptr<coil_tracking::CoilTracker>> trackers;
  for (const auto& model : models) {
    trackers.push_back(
        context.registrations.coil_trackers.create(context.registrations.coil_trackers.defaultName()));
    trackers.back()->start(recording.rig, model);
  }
  std::vector<MarkerPoses> poses(models.size());
  const auto source = capture::makeSource(recording);
  while (const auto frame = source->next()) {
    context.monitor.report("tracking", double(poses[0].size()) / double(recording.frame_count));
    for (std::size_t i = 0; i < models.size(); ++i) poses[i].push_back(trackers[i]->track(*frame));
  }
  return poses;
}

coil_tracking::CoilCalibration fromJig(Context& context, const CalibrateCoilRequest& request,
                                       const coil_tracking::CoilModel& coil) {
  const auto jig = coil_tracking::readCoil(request.jig);
  const auto poses = trackMarkers(context, request.recording, {coil, jig});
  std::vector<coil_tracking::JigObservation> observations;
  for (std::size_t i = 0; i < poses[0].size(); ++i)
    if (poses[0][i] && poses[1][i])
      observations.push_back({poses[0][i]->camera_T_marker, poses[1][i]->camera_T_marker});
  return coil_tracking::calibrateWithJig(observations, jig.markers.front().coil_T_marker);
}

coil_tracking::Pivot pivot(Context& context, const std::filesystem::path& folder,
                           const coil_tracking::CoilModel& coil) {
  std::vector<RigidTransform<Camera, Marker>> poses;
  for (const auto& pose : trackMarkers(context, folder, {coil}).front())
    if (pose) poses.push_back(pose->camera_T_marker);
  return coil_tracking::fitPivot(poses);
}

void run(Context& context, CalibrateCoilRequest request) {
  if (!request.coil_words.empty())
    request.coil = coil_library::coilFileOf(request.coil_words, coil_library::coilLibrary(request.library));
  const auto coil =
      request.coil.empty() ? coil_tracking::defaultCoil() : coil_tracking::readCoil(request.coil);
  const bool has_pivots = !request.centre.empty() && !request.handle.empty() && !request.side.empty();
  const bool has_jig = !request.jig.empty() && !request.recording.empty();
  if (has_jig == has_pivots)
    throw WrongUsage("give a RECORDING with --jig, or --centre, --handle and --side");
  auto result = has_jig ? fromJig(context, request, coil)
                        : coil_tracking::calibrateWithPivots(pivot(context, request.centre, coil),
                                                             pivot(context, request.handle, coil),
                                                             pivot(context, request.side, coil));
  result.utc = isoUtc(std::chrono::system_clock::now());
  coil_tracking::writeCalibratedCoil(coil, result, request.output, request.coil);
  if (request.is_json)
    return printJson({{"output", request.output.string()},
                      {"used", result.used},
                      {"frames", result.frames},
                      {"rms_mm", result.rms_mm},
                      {"sigma_mm", result.sigma_mm},
                      {"sigma_deg", result.sigma_deg}});
  if (context.is_quiet) return;
  std::printf("%s: %d of %d frames, residual rms %.2f mm; standard error %.2f mm, %.2f deg\n",
              request.output.c_str(), result.used, result.frames, result.rms_mm, result.sigma_mm,
              result.sigma_deg);
}

}  // namespace

void addCalibrateCoil(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("calibrate-coil", "where the coil's face lies relative to its marker -> coil.json");
  auto request = std::make_shared<CalibrateCoilRequest>();
  verb->add_option("RECORDING", request->recording, "coil and jig, both markers in view");
  verb->add_option("--jig", request->jig,
                   "the jig's marker and its place on the coil: as coil.json, with the jig's marker");
  verb->add_option("--centre", request->centre, "recording: the contact centre turned about a fixed tip");
  verb->add_option("--handle", request->handle,
                   "recording: a point of the handle's axis turned about the tip");
  verb->add_option("--side", request->side,
                   "recording: a point of the face, left of one who holds the handle, turned about the tip");
  verb->add_option("--coil", request->coil_words,
                   "coil.json with the marker, or a coil's name in the library (without it: 60 mm, 4x4_50, "
                   "id 7)");
  addCoilLibraryOption(*verb, request->library);
  verb->add_option("-o,--output", request->output, "coil.json to write")->required();
  verb->add_flag("--json", request->is_json, "the result as JSON");
  verb->callback([&context, request] { run(context, *request); });
}

}  // namespace facenav::app
