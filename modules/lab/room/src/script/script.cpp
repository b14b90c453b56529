#include "script.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "habits.h"
#include "script_setting.h"

namespace facenav::room {
namespace {

/// A script defined by one function, plus the patient's habits.
class FunctionScript : public Script {
 public:
  FunctionScript(const Setting& setting, Cast capture, MomentOf moment)
      : frames_(setting.frames),
        options_(setting.options),
        capture_(std::move(capture)),
        moment_(std::move(moment)) {}
  int frameCount() const override { return frames_; }
  Moment at(double frame) const override {
    Moment moment = moment_(frame);
    Cast& cast = moment.cast;
    cast.gloss = capture_.gloss;
    if (options_.blinks > 0)
      cast.expression.blink = lidsDown(options_.seed, frame / options_.frames_per_s + moment.later_s);
    cast.hair =
        looseHair(options_.hair_sway_mm, capture_.room_T_mri, cast.room_T_mri, options_.seed, moment.visit);
    return moment;
  }
  Cast capture() const override { return capture_; }

 private:
  int frames_;
  ScenarioOptions options_;  // resolved
  Cast capture_;
  MomentOf moment_;
};

MomentOf momentsOf(const Setting& setting) {
  static const std::map<std::string, MomentOf (*)(const Setting&)> scripts{
      {"capture", stillScript},
      {"still", stillScript},
      {"protractor", protractorScript},
      {"free_motion", freeMotionScript},
      {"occlusion", occlusionScript},
      {"talking", talkingScript},
      {"lighting", lightingScript},
      {"lost", lostScript},
      {"glint", glintScript},
      {"mask", maskScript},
      {"mask_on", maskScript},
      {"other_face", otherFaceScript},
      {"coil_sweep", coilSweepScript},
      {"treatment", [](const Setting& s) { return treatmentScript(s); }},
      {"grimace", grimaceScript},
      {"grimace_other", grimaceScript},
      {"returns", returnsScript},
      {"out_of_step", outOfStepScript},
      {"moments", momentsScript},
      {"moments_other", momentsScript},
      {"drift", driftScript},
      {"drift_face", driftScript},
      {"webcam", [](const Setting& s) { return treatmentScript(s); }},
      {"unsynced", [](const Setting& s) { return treatmentScript(s); }},
      {"autoexposure", [](const Setting& s) { return treatmentScript(s); }},
      {"refocus", [](const Setting& s) { return treatmentScript(s); }},
      {"fast_coil", fastCoilScript},
      {"glasses", glassesScript},
      {kPlainAlign, turningScript}};
  return scripts.at(setting.options.name)(setting);
}

/// Rotation (rad) and shift (mm) of a patient who does not sit straight: directions uniform, sizes uniform up
/// to the options' limits. Zero if these are 0.
Vector6d seatError(const ScenarioOptions& options) {
  std::mt19937_64 random(options.seed * 7919 + 17);
  const auto uniform = [&random] { return double(random() >> 11) * 0x1p-53; };
  const auto direction = [&uniform] {
    const double z = 2.0 * uniform() - 1.0, about = 2.0 * M_PI * uniform(), r = std::sqrt(1.0 - z * z);
    return Eigen::Vector3d(r * std::cos(about), r * std::sin(about), z);
  };
  Vector6d error;
  error.head<3>() = options.seat_turn_deg * kRadPerDeg * uniform() * direction();
  error.tail<3>() = options.seat_shift_mm * uniform() * direction();
  return error;
}

}  // namespace

const ScenarioKind& kindOf(const std::string& name) {
  const auto& kinds = scenarios();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.name == name; });
  if (kind != kinds.end()) return *kind;
  std::string names;
  for (const auto& k : kinds) names += (names.empty() ? "" : ", ") + k.name;
  throw Error("no scenario of this name", name, "one of: " + names);
}

Parts::Place Parts::at(double share) const {
  double from = 0.0;
  auto now = parts_.begin();
  while (share >= now->until) from = (now++)->until;
  return {now->label, (share - from) / (now->until - from)};
}

RigidTransform<Room, Mri> seatedHead(const ScenarioOptions& options, const VirtualPatient& patient) {
  // The patient looks at the cameras: anterior towards them, superior up, the patient's right on the image's
  // left.
  Eigen::Matrix3d room_R_mri;
  room_R_mri << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  // No seat is exactly square to the rig.
  room_R_mri = expRotation(Eigen::Vector3d(2.0, -3.0, 1.0) * kRadPerDeg) * room_R_mri;
  const Vector6d error = seatError(options);
  const Eigen::Vector3d centre_mm(4.0, 0.07 * options.head_distance_mm, options.head_distance_mm);
  const Eigen::Vector3d anchor = 0.6 * patient.face_middle.mm + 0.4 * patient.head_centre.mm;
  const double depth_mm = (room_R_mri * (patient.face_middle.mm - anchor)).z();
  const Eigen::Vector3d anchor_mm = centre_mm - Eigen::Vector3d(0, 0, depth_mm) + error.tail<3>();
  room_R_mri = expRotation(error.head<3>()) * room_R_mri;
  return {Eigen::Quaterniond(room_R_mri), anchor_mm - room_R_mri * anchor};
}

std::unique_ptr<Script> makeScript(const ScenarioOptions& options, const VirtualPatient& patient,
                                   const RigidTransform<Mri, frames::Target>& target,
                                   const RigidTransform<Marker, Coil>& marker_T_coil,
                                   const std::optional<RigidTransform<Mri, frames::Target>>& second_target) {
  const ScenarioKind& kind = kindOf(options.name);
  Setting setting;
  setting.options = resolved(options);
  setting.seat = seatedHead(setting.options, patient);
  setting.pivot = patient.head_centre;
  setting.face_middle = patient.face_middle;
  setting.target = target;
  setting.second_target = second_target;
  setting.marker_T_coil = marker_T_coil;
  setting.frames = options.frames > 0 ? options.frames : kind.frames;
  Cast capture;
  capture.room_T_mri = setting.seat;
  capture.has_mask = kind.name == "mask";
  capture.gloss = setting.options.gloss;
  capture.hair.sway_mm = setting.options.hair_sway_mm;
  capture.expression = captureExpression(setting.options);
  return std::make_unique<FunctionScript>(setting, capture, momentsOf(setting));
}

}  // namespace facenav::room
