// facenav rig new|check|list: camera pairs kept under a name, with locked settings and calibration, and
// checked again.

#include <cstdio>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "facenav/cameras/calibrate.h"
#include "facenav/capture/calibration_images.h"
#include "facenav/capture/recording.h"
#include "facenav/capture/rig_store.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/workflow/verify_rig.h"

namespace facenav::app {
namespace {

using RigJson = nlohmann::ordered_json;

constexpr double kSettle_s = 1.0;  // a camera's automatic exposure has settled by then
constexpr int kMostFrames = 60;    // of a recording that are looked at

struct RigRequest {
  std::string name, board, left_camera, right_camera;
  std::filesystem::path rigs, calibration, recording, coil;
  double square_mm = 0, distance_mm = 600, live_s = 0;
  std::vector<std::string> left, right;
  capture::CameraSettings settings;
  bool is_json = false, is_replacing = false;
};

std::string rigUtcNow() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

std::optional<cameras::Board> boardOf(const RigRequest& request) {
  if (request.board.empty()) return std::nullopt;
  if (!(request.square_mm > 0))
    throw Error("the size of the board's squares is missing", "--square", "measure a square, in mm");
  return cameras::boardFromText(request.board, request.square_mm);
}

// ---- rig new

cameras::StereoRig calibrated(const RigRequest& request, Context& context) {
  if (!request.calibration.empty()) return cameras::readRig(request.calibration);
  const auto board = boardOf(request);
  if (!board || request.left.empty() || request.right.empty())
    throw Error("the calibration is missing", "",
                "give --calibration stereo.yml, or --board, --square, --left and --right pictures");
  const auto result = cameras::calibrate(capture::readCalibrationImages(request.left, request.right), *board,
                                         context.monitor);
  for (const auto& warning : result.warnings) logWarning(warning);
  return result.rig;
}

std::optional<capture::RigUncertainty_mm> uncertaintyAt(const cameras::StereoRig& rig, double distance_mm) {
  if (rig.covariance.empty()) return std::nullopt;
  return capture::RigUncertainty_mm{distance_mm, cameras::effectAtHead(rig, {0, 0, distance_mm}).point_mm};
}

/// The values that the cameras have now: kept, so that they are the same at each start.
void keepLocked(const capture::CameraState& state, capture::CameraSettings& settings) {
  const auto keep = [&](const char* name, std::optional<double>& value) {
    for (const auto& control : state.controls)
      if (control.name == name && control.lock == capture::ControlState::Lock::locked) value = control.actual;
  };
  keep("exposure", settings.exposure_ms);
  keep("gain", settings.gain);
  keep("focus", settings.focus);
  keep("white balance", settings.white_balance_k);
  if (state.format != "stream") settings.format = state.format;
}

void addCamerasTo(capture::NamedRig& rig, const RigRequest& request, const Context& context) {
  const auto found = capture::listCameras(context.registrations.cameras);
  rig.left = {capture::findCamera(found, request.left_camera), request.settings};
  rig.right = {capture::findCamera(found, request.right_camera), request.settings};
  const auto source = capture::openRig(context.registrations.cameras, rig);
  for (const double until_s = Timestamp::now().s + kSettle_s; Timestamp::now().s < until_s;)
    if (!source->next()) break;
  keepLocked(source->leftState(), rig.left->settings);
  keepLocked(source->rightState(), rig.right->settings);
  for (const auto& words : source->cautions()) logWarning(words);
}

std::string uncertaintyInWords(const capture::NamedRig& rig) {
  if (!rig.uncertainty) return "uncertainty unknown: its stereo.yml has no covariance";
  return formatted("+-%.2f mm at %.0f mm", rig.uncertainty->point_mm, rig.uncertainty->distance_mm);
}

void makeRig(const RigRequest& request, Context& context) {
  if (request.left_camera.empty() != request.right_camera.empty())
    throw Error("one of the two cameras is missing", "", "give --left-camera and --right-camera, or neither");
  const capture::RigStore store(request.rigs);
  if (!request.is_replacing && std::filesystem::exists(store.folderOf(request.name)))
    throw Error("there is a rig of this name", store.folderOf(request.name).string(),
                "choose another, or give --replace");
  capture::NamedRig rig;
  rig.name = request.name;
  rig.created_utc = rigUtcNow();
  rig.rig = calibrated(request, context);
  rig.uncertainty = uncertaintyAt(rig.rig, request.distance_mm);
  if (!request.left_camera.empty()) addCamerasTo(rig, request, context);
  store.write(rig, request.is_replacing ? Existing::replace : Existing::refuse);
  std::printf("%s: %d x %d px, %.1f mm apart, %s: %s\n", rig.name.c_str(), rig.rig.width_px,
              rig.rig.height_px, rig.rig.baseline_mm(), uncertaintyInWords(rig).c_str(),
              store.folderOf(rig.name).c_str());
  if (!rig.left)
    logWarning(
        "the rig knows no cameras; with --left-camera and --right-camera it keeps which two, and their "
        "settings");
}

// ---- rig check

using FrameTaker = std::function<void(const cameras::StereoFrame&)>;

void takeFrames(capture::FrameSource& source, std::int64_t step, const FrameTaker& take) {
  for (std::int64_t i = 0; const auto frame = source.next(); ++i)
    if (i % step == 0) take(*frame);
}

void takeLive(const capture::NamedRig& rig, const RigRequest& request, const Context& context,
              const FrameTaker& take) {
  const auto source = capture::openRig(context.registrations.cameras, rig);
  double next_s = Timestamp::now().s;
  for (const double until_s = next_s + request.live_s; Timestamp::now().s < until_s;) {
    const auto frame = source->next();
    if (!frame) break;
    if (Timestamp::now().s < next_s) continue;
    next_s = Timestamp::now().s + request.live_s / kMostFrames;
    take(*frame);
  }
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
    throw Error("it is not said what to check the rig with", "",
                "give a recording, or --left and --right pictures, or --live");
  if (request.live_s > 0) return takeLive(rig, request, context, take);
  if (request.recording.empty()) return takePictures(request, take);
  const auto recording = capture::openRecording(request.recording);
  takeFrames(*capture::makeSource(recording), std::max<std::int64_t>(1, recording.frame_count / kMostFrames),
             take);
}

std::string checkJson(const workflow::RigVerification& result) {
  RigJson lengths = RigJson::array();
  for (const auto& length : result.lengths)
    lengths.push_back({{"what", length.what},
                       {"true_mm", length.true_mm},
                       {"measured_mm", length.measured_mm},
                       {"sigma_mm", length.sigma_mm}});
  const RigJson json = {{"state", workflow::toString(result.state)},
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
                        {"point_error_mm", result.point_error_mm}};
  return json.dump(1, ' ', false, RigJson::error_handler_t::replace);
}

void checkRig(const RigRequest& request, Context& context) {
  const capture::RigStore store(request.rigs);
  const capture::NamedRig rig = store.read(request.name);
  const auto coil =
      request.coil.empty() ? coil_tracking::defaultCoil() : coil_tracking::readCoil(request.coil);
  const auto& trackers = context.registrations.coil_trackers;
  workflow::RigVerifier verifier(rig.rig, boardOf(request), trackers.create(trackers.defaultName()), coil);
  takeAll(rig, request, context, [&](const cameras::StereoFrame& frame) { verifier.add(frame); });
  const workflow::RigVerification result = verifier.result();
  store.note(request.name, {rigUtcNow(), workflow::toString(result.state), result.words()});
  if (request.is_json) {
    std::printf("%s\n", checkJson(result).c_str());
  } else {
    for (const auto& line : result.findings()) std::printf("%s\n", line.c_str());
    if (result.state == workflow::RigState::holds)
      std::printf("%s: %s\n", request.name.c_str(), result.words().c_str());
  }
  if (result.state != workflow::RigState::holds) throw Error(request.name + ": " + result.words());
}

// ---- rig list

RigJson cameraEntry(const std::optional<capture::RigCamera>& camera) {
  return camera ? RigJson(capture::stableName(camera->identity)) : RigJson(nullptr);
}

RigJson entryJson(const capture::RigEntry& entry) {
  RigJson json = {{"name", entry.name}, {"folder", entry.folder.string()}};
  if (!entry.rig) {
    json["problem"] = entry.problem;
    return json;
  }
  const capture::NamedRig& rig = *entry.rig;
  json.update({{"created", rig.created_utc},
               {"left", cameraEntry(rig.left)},
               {"right", cameraEntry(rig.right)},
               {"width_px", rig.rig.width_px},
               {"height_px", rig.rig.height_px},
               {"baseline_mm", rig.rig.baseline_mm()}});
  if (rig.uncertainty)
    json.update(
        {{"distance_mm", rig.uncertainty->distance_mm}, {"uncertainty_mm", rig.uncertainty->point_mm}});
  if (rig.last_check)
    json["last_check"] = {
        {"utc", rig.last_check->utc}, {"state", rig.last_check->state}, {"words", rig.last_check->words}};
  return json;
}

void printEntry(const capture::RigEntry& entry) {
  if (!entry.rig)
    return void(std::printf("%-20s unreadable: %s\n", entry.name.c_str(), entry.problem.c_str()));
  const capture::NamedRig& rig = *entry.rig;
  std::printf("%-20s %s  %d x %d px, %.1f mm apart, %s\n", entry.name.c_str(), rig.created_utc.c_str(),
              rig.rig.width_px, rig.rig.height_px, rig.rig.baseline_mm(), uncertaintyInWords(rig).c_str());
  for (const auto& [side, camera] : {std::pair("left", &rig.left), std::pair("right", &rig.right)})
    std::printf("  %-5s %s\n", side,
                *camera ? capture::inWords((*camera)->identity).c_str() : "no camera: made from files");
  if (rig.last_check)
    std::printf("  checked %s: %s\n", rig.last_check->utc.c_str(), rig.last_check->words.c_str());
  else
    std::printf("  never checked\n");
}

void listRigs(const RigRequest& request) {
  const capture::RigStore store(request.rigs);
  const auto entries = store.list();
  if (request.is_json) {
    RigJson list = RigJson::array();
    for (const auto& entry : entries) list.push_back(entryJson(entry));
    std::printf("%s\n", list.dump(1, ' ', false, RigJson::error_handler_t::replace).c_str());
    return;
  }
  for (const auto& entry : entries) printEntry(entry);
  if (entries.empty()) std::printf("no rig in %s; make one with: facenav rig new\n", store.folder().c_str());
}

// ---- options

void addBoardOptions(CLI::App& verb, RigRequest& request) {
  verb.add_option("--board", request.board, "board: 9x6 inner corners, or charuco:7x5 squares");
  verb.add_option("--square", request.square_mm, "side of one square, mm");
  verb.add_option("--left", request.left,
                  "left pictures of the board: files or a quoted pattern, 'left*.png'");
  verb.add_option("--right", request.right, "right pictures, in the same way");
}

void addNew(CLI::App& rig, const std::shared_ptr<RigRequest>& request, Context& context) {
  auto* verb = rig.add_subcommand(
      "new", "keeps two cameras, their locked settings and their calibration under a name");
  verb->add_option("NAME", request->name, "of the rig")->required();
  verb->add_option("--rigs", request->rigs, "folder of the rigs (default: the user's configuration)");
  verb->add_option("--calibration", request->calibration, "stereo.yml; or calibrate here, from pictures:");
  addBoardOptions(*verb, *request);
  verb->add_option("--left-camera", request->left_camera, "name or address, see 'facenav cameras'");
  verb->add_option("--right-camera", request->right_camera, "likewise");
  verb->add_option("--rate", request->settings.frames_per_s, "pictures a second")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1000.0));
  verb->add_option("--format", request->settings.format,
                   "GREY, YUYV or MJPG; default: the best that is fast enough");
  verb->add_option("--exposure-ms", request->settings.exposure_ms,
                   "default: as the camera has it now; likewise:");
  verb->add_option("--gain", request->settings.gain, "in the camera's steps");
  verb->add_option("--focus", request->settings.focus, "in the camera's steps");
  verb->add_option("--white-balance-k", request->settings.white_balance_k, "colour temperature");
  verb->add_option("--distance", request->distance_mm,
                   "mm from the left camera to the target, for the stated uncertainty")
      ->capture_default_str()
      ->check(CLI::Range(100.0, 5000.0));
  verb->add_flag("--replace", request->is_replacing, "replaces a rig of this name");
  verb->callback([request, &context] { makeRig(*request, context); });
}

void addCheckOf(CLI::App& rig, const std::shared_ptr<RigRequest>& request, Context& context) {
  auto* verb = rig.add_subcommand(
      "check", "does the calibration still hold? From a board in a new position, or the coil's marker");
  verb->add_option("NAME", request->name, "of the rig")->required();
  verb->add_option("RECORDING", request->recording, "recording that shows the board or the coil's marker");
  verb->add_option("--rigs", request->rigs, "folder of the rigs (default: the user's configuration)");
  addBoardOptions(*verb, *request);
  verb->add_option("--live", request->live_s, "s: look through the rig's own cameras for so long")
      ->check(CLI::Range(0.2, 600.0));
  verb->add_option("--coil", request->coil, "coil.json with the marker; default: 60 mm, 4x4_50, id 7");
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->callback([request, &context] { checkRig(*request, context); });
}

}  // namespace

void addRig(CLI::App& app, Context& context) {
  auto* rig = app.add_subcommand("rig", "camera pairs kept under a name: new, check, list");
  rig->require_subcommand(1);
  const auto request = std::make_shared<RigRequest>();
  addNew(*rig, request, context);
  addCheckOf(*rig, request, context);
  auto* list = rig->add_subcommand("list", "the rigs: cameras, size, date, uncertainty, last check");
  list->add_option("--rigs", request->rigs, "folder of the rigs (default: the user's configuration)");
  list->add_flag("--json", request->is_json, "as JSON");
  list->callback([request] { listRigs(*request); });
}

}  // namespace facenav::app
