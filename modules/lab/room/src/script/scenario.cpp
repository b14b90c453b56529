#include "facenav/room/scenario.h"

#include <algorithm>
#include <iterator>

#include "facenav/core/error.h"
#include "script.h"

namespace facenav::room {
namespace {

constexpr int kGrimaceFrames = 78, kReturnsFrames = 154, kMomentsFrames = 83, kCoarseJpeg = 50;
constexpr double kShiningSkin = 0.6;
// For "moments": chosen on the pictures of ../shared/data/real_faces.
constexpr int kRealJpeg = 35;
constexpr double kRealGloss = 0.8;
// For "plain_align": two seconds at a webcam's rate; skin between a rendered face's and that of "moments".
constexpr int kTurnFrames = 40, kWebcamJpeg = 75;
// For webcams: typical of USB cameras of 30 frames a second, chosen before anything was measured with them.
constexpr int kWebcamFrames = 120;
constexpr double kFocalPerWidth = 0.83;  // 62 deg across
constexpr double kWebcamFrames_per_s = 30.0, kRolling_ms = 20.0, kExposure_ms = 10.0, kRightGain = 0.85,
                 kRightGamma = 0.85, kRightLate_ms = 9.0, kClock_ppm = 200.0, kDropped = 0.03,
                 kDoubled = 0.02, kExposureStep = 0.3, kRefocus_px = 1.5;
constexpr double kTurnFrames_per_s = 20.0, kFaintSkin = 0.3, kDullGloss = 0.3;

const char* const kDriftsAbout[] = {"yaw", "pitch", "roll", "shift"};

struct OwnWhereUsual {
  template <class Value>
  void operator()(Value& value, const Value& usual, const Value& own) const {
    if (value == usual) value = own;
  }
};

/// Places the cameras close to the face, unless the rig's options were changed.
void moveClose(ScenarioOptions& options) {
  const ScenarioOptions usual;
  const RigOptions close = closeRig();
  const OwnWhereUsual own;
  own(options.head_distance_mm, usual.head_distance_mm, kCloseHead_mm);
  own(options.rig.width_px, usual.rig.width_px, close.width_px);
  own(options.rig.height_px, usual.rig.height_px, close.height_px);
  own(options.rig.focal_px, usual.rig.focal_px, close.focal_px);
  own(options.rig.baseline_mm, usual.rig.baseline_mm, close.baseline_mm);
  own(options.rig.convergence_deg, usual.rig.convergence_deg, close.convergence_deg);
}

/// Sets skin of little contrast, filmed at a webcam's rate.
void makeFaint(ScenarioOptions& options) {
  const ScenarioOptions usual;
  const OwnWhereUsual own;
  own(options.skin_contrast, usual.skin_contrast, kFaintSkin);
  own(options.frames_per_s, usual.frames_per_s, kTurnFrames_per_s);
}

bool isOfWebcams(const std::string& scenario) {
  static const char* const kNames[] = {"webcam",  "unsynced",  "autoexposure",
                                       "refocus", "fast_coil", "glasses"};
  return std::find(std::begin(kNames), std::end(kNames), scenario) != std::end(kNames);
}

/// Sets two USB cameras without a trigger.
void makeWebcams(ScenarioOptions& options) {
  const ScenarioOptions usual;
  const OwnWhereUsual own;
  own(options.frames_per_s, usual.frames_per_s, kWebcamFrames_per_s);
  own(options.rolling_ms, usual.rolling_ms, kRolling_ms);
  own(options.exposure_ms, usual.exposure_ms, kExposure_ms);
  own(options.right_gain, usual.right_gain, kRightGain);
  own(options.right_gamma, usual.right_gamma, kRightGamma);
  if (options.name == "autoexposure") own(options.exposure_step, usual.exposure_step, kExposureStep);
  if (options.name == "refocus") own(options.refocus_px, usual.refocus_px, kRefocus_px);
  if (options.name != "unsynced") return;
  own(options.right_late_ms, usual.right_late_ms, kRightLate_ms);
  own(options.clock_ppm, usual.clock_ppm, kClock_ppm);
  own(options.dropped, usual.dropped, kDropped);
  own(options.doubled, usual.doubled, kDoubled);
}

/// Sets cameras with more pixels at the room's position and baseline.
void makeSize(ScenarioOptions& options, int width_px, int height_px) {
  const ScenarioOptions usual;
  const OwnWhereUsual own;
  own(options.rig.width_px, usual.rig.width_px, width_px);
  own(options.rig.height_px, usual.rig.height_px, height_px);
  own(options.rig.focal_px, usual.rig.focal_px, kFocalPerWidth * width_px);
}

/// Sets low skin contrast, glare, moving hair, slightly different colour sensors.
void makeReal(ScenarioOptions& options) {
  const ScenarioOptions usual;
  const OwnWhereUsual own;
  own(options.haze_grey, usual.haze_grey, 80.0);
  own(options.exposure, usual.exposure, 0.5);
  own(options.noise_grey, usual.noise_grey, 0.7);
  own(options.skin_contrast, usual.skin_contrast, 0.12);
  own(options.grey_red, usual.grey_red, 0.299);
  own(options.grey_blue, usual.grey_blue, 0.114);
  own(options.right_grey_red, usual.right_grey_red, 0.34);
  own(options.right_grey_blue, usual.right_grey_blue, 0.09);
  own(options.hair_sway_mm, usual.hair_sway_mm, 4.0);
  own(options.bayer, usual.bayer, 1);
  own(options.rig_name, usual.rig_name, std::string("close"));
}

/// Scenarios of a treatment before synchronised cameras, and what may disturb it.
std::vector<ScenarioKind> treatmentScenarios() {
  return {
      {"capture", "the still pair for the alignment, and one plain frame", 1},
      {"protractor", "head at -12.5 .. 12.5 deg in steps of 2.5 about each axis, as in the paper", 33},
      {"treatment", "natural head motion; the coil is brought to the target and held for the last second",
       150},
      {"still", "nothing moves; only the sensor noise changes", 20},
      {"free_motion", "the head turns by 30 deg, nods and tilts by 15, shifts by 60 mm, up to 100 mm/s", 240},
      {"occlusion", "a hand, then the coil, hides up to 40 % of the face", 150},
      {"talking", "the patient talks and blinks", 150},
      {"lighting", "lamps change by 40 % and move", 150},
      {"glint", "sweat on the skin: hard highlights that wander as the head moves", 120},
      {"mask", "the patient wears a surgical mask, at the capture too", 100},
      {"mask_on", "the mask is put on after the capture", 100},
      {"other_face", "another person's face takes the patient's place, at once and walking in", 150},
      {"coil_sweep", "the coil's marker at 400-900 mm, tilted up to 60 deg", 120},
      {"drift",
       "face and coil, while the right camera turns slowly on its mount (0.3 deg; or shifts by 1 mm)", 240},
      {"drift_face", "the same without the coil", 240},
      {"lost", "face away, head out of view, cameras black, frozen, swapped: each frame labelled", 180},
  };
}

/// Scenarios in which the patient moves the face or is away in between, and comes back.
std::vector<ScenarioKind> returnScenarios() {
  return {
      {"grimace",
       "the patient comes back four times, each time after 1.4 s, elsewhere (0.5-5 deg, 3-16 mm) and with "
       "another grimace",
       kGrimaceFrames, kCoarseJpeg, kShiningSkin, true},
      {"grimace_other", "the same, and another person sits there at the second return", kGrimaceFrames,
       kCoarseJpeg, kShiningSkin, true},
      {"returns",
       "the patient walks out of the pictures three times and comes back in other light, with another "
       "grimace, turned by 5-15 deg",
       kReturnsFrames, kCoarseJpeg, kShiningSkin, true},
      {"out_of_step",
       "from frame 24 on the right camera's picture is older than the left one's: the head moved by 3-10 mm "
       "in between",
       60, kCoarseJpeg, kShiningSkin},
      {"moments",
       "five moments some seconds apart as a real face shows them to near cameras: other grimace, other "
       "place "
       "(0.5-5 deg, 3-16 mm), other hair, faint skin, blinks, coarse JPEG; the patient is away in between",
       kMomentsFrames, kRealJpeg, kRealGloss, true, true},
      {"moments_other", "the same, and another person sits there at the third and the fourth moment",
       kMomentsFrames, kRealJpeg, kRealGloss, true, true},
  };
}

/// Scenarios of treatments and of the alignment before two webcams.
std::vector<ScenarioKind> webcamScenarios() {
  return {
      {"webcam",
       "treatment before two webcams: rolling shutter (20 ms), exposure (10 ms), JPEG 75, unequal tone "
       "curves",
       kWebcamFrames, kWebcamJpeg, kDullGloss},
      {"unsynced", "the same; the right camera is 9 ms late, its clock drifts, pairs are lost and come twice",
       kWebcamFrames, kWebcamJpeg, kDullGloss},
      {"autoexposure", "the same webcams in step; their exposure steps by 30 % every second", kWebcamFrames,
       kWebcamJpeg, kDullGloss},
      {"refocus", "the same webcams in step; both lose focus by 1.5 px for a while", kWebcamFrames,
       kWebcamJpeg, kDullGloss},
      {"fast_coil", "before the same webcams the coil swings at up to 300 mm/s beside the face",
       kWebcamFrames, kWebcamJpeg, kDullGloss},
      {"glasses", "before the same webcams the patient puts glasses on", kWebcamFrames, kWebcamJpeg,
       kDullGloss},
      {kPlainAlign,
       "to align without a projector: faint skin, JPEG; in two seconds the head turns slowly by 15 deg to "
       "both sides",
       kTurnFrames, kWebcamJpeg, kDullGloss, true},
  };
}

}  // namespace

const std::vector<ScenarioKind>& scenarios() {
  static const std::vector<ScenarioKind> kinds = [] {
    std::vector<ScenarioKind> all = treatmentScenarios();
    for (auto&& group : {returnScenarios(), webcamScenarios()})
      all.insert(all.end(), group.begin(), group.end());
    return all;
  }();
  return kinds;
}

ScenarioOptions resolved(ScenarioOptions options) {
  const ScenarioKind& kind = kindOf(options.name);
  if (options.jpeg_quality < 0) options.jpeg_quality = kind.jpeg_quality;
  if (options.gloss < 0.0) options.gloss = kind.gloss;
  if (options.blinks < 0) options.blinks = kind.blinks;
  if (kind.is_real) makeReal(options);
  if (kind.name == kPlainAlign) makeFaint(options);
  if (isOfWebcams(kind.name)) makeWebcams(options);
  const bool drifts = kind.name.rfind("drift", 0) == 0;
  if (drifts && options.drift_about.empty()) options.drift_about = kDriftsAbout[(options.seed + 3) % 4];
  if (drifts && std::find(std::begin(kDriftsAbout), std::end(kDriftsAbout), options.drift_about) ==
                    std::end(kDriftsAbout))
    throw Error("a camera does not drift in this way", options.drift_about,
                "one of: yaw, pitch, roll, shift");
  if (options.hair_sway_mm < 0.0) options.hair_sway_mm = 0.0;
  if (options.bayer < 0) options.bayer = 0;
  if (options.rig_name.empty()) options.rig_name = "room";
  if (options.rig_name == "close")
    moveClose(options);
  else if (options.rig_name == "720p")
    makeSize(options, 1280, 720);
  else if (options.rig_name == "1080p")
    makeSize(options, 1920, 1080);
  else if (options.rig_name != "room")
    throw Error("no rig of this name", options.rig_name, "one of: room, close, 720p, 1080p");
  return options;
}

}  // namespace facenav::room
