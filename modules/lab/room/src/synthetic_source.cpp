#include "facenav/room/synthetic_source.h"

#include <array>
#include <random>

#include "props/coil_mount.h"
#include "script/script.h"
#include "sensor_faults.h"
#include "stage.h"

namespace facenav::room {
namespace {

constexpr std::uint64_t kFramesPerSeed = 1000003;

/// Films of left and right: the seed sets the glare's gradient, different in each camera.
std::array<FilmOptions, 2> filmsOf(const ScenarioOptions& options) {
  std::array<FilmOptions, 2> films;
  std::mt19937_64 random(options.seed * 6151 + 29);
  const auto gradient = [&random] { return double(random() >> 11) * 0x1p-53 - 0.5; };
  for (FilmOptions& film : films) {
    film = {options.blur_px, options.exposure, options.gamma, options.noise_grey, options.haze_grey};
    film.haze_right = gradient();
    film.haze_down = gradient();
    film.jpeg_quality = options.jpeg_quality;
    film.is_bayer = options.bayer > 0;
  }
  films[0].red_share = options.grey_red, films[0].blue_share = options.grey_blue;
  films[1].red_share = options.right_grey_red, films[1].blue_share = options.right_grey_blue;
  films[1].exposure *= options.right_gain;
  films[1].gamma *= options.right_gamma;
  return films;
}

/// Rig as its file gives it.
cameras::StereoRig statedRig(const ScenarioOptions& options) {
  cameras::StereoRig rig = makeRig(options.rig);
  const double row_time_s = 1e-3 * options.rolling_ms / rig.height_px;
  rig.left.row_time_s = rig.right.row_time_s = options.stated_row_time * row_time_s;
  return rig;
}

std::shared_ptr<const VirtualPatient> seated(const ScenarioOptions& options,
                                             const std::shared_ptr<const VirtualPatient>& patient) {
  if (options.skin_contrast == 1.0) return patient;
  return std::make_shared<const VirtualPatient>(withSkinContrast(*patient, options.skin_contrast));
}

RoomCoil coilFor(const ScenarioOptions& options, const VirtualPatient& patient,
                 const RigidTransform<Mri, frames::Target>& target) {
  const auto rig = makeRig(options.rig);
  return mountedCoil(target, patient,
                     {rig, cameraFromRoom(rig, options.rig.roll_deg), seatedHead(options, patient)});
}

/// Returns the same pose on the other side of the head.
std::optional<RigidTransform<Mri, frames::Target>> secondTargetOf(
    const ScenarioOptions& options, const VirtualPatient& patient,
    const RigidTransform<Mri, frames::Target>& target) {
  if (options.coils < 2) return std::nullopt;
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  Eigen::Isometry3d other = target.isometry();
  other.linear() = mirror * target.rotation() * mirror;  // the second factor keeps it a rotation
  other.translation().x() = 2 * patient.head_centre.mm.x() - other.translation().x();
  return RigidTransform<Mri, frames::Target>::fromIsometry(other);
}

}  // namespace

struct SyntheticSource::Implementation {
  ScenarioOptions options;
  RigidTransform<Mri, frames::Target> target;
  std::optional<RigidTransform<Mri, frames::Target>> second_target;
  Stage stage;
  std::unique_ptr<Script> script;
  std::int64_t number = 0;
  cameras::StereoFrame last;
  GroundTruth truth;

  Implementation(const ScenarioOptions& o, const std::shared_ptr<const VirtualPatient>& patient,
                 const RigidTransform<Mri, frames::Target>& t)
      : options(resolved(o)),
        target(t),
        second_target(secondTargetOf(options, *patient, t)),
        stage(statedRig(options), options.rig.roll_deg, seated(options, patient),
              coilFor(options, *patient, t), filmsOf(options)),
        script(makeScript(options, *patient, t, stage.coil().marker_T_coil, second_target)) {
    if (!second_target) return;
    RoomCoil second = coilFor(options, *patient, *second_target);
    second.name += " B";
    second.marker_id += 1;
    stage.addSecondCoil(second);
  }

  cameras::StereoFrame photograph(const Moment& moment) {
    const CameraFault fault = moment.fault;
    if (fault == CameraFault::frozen && !last.left.empty())
      return {last.left.clone(), last.right.clone(), number, {}};
    const std::uint64_t seed = options.seed * kFramesPerSeed + std::uint64_t(number);
    const bool is_black = fault == CameraFault::black_both;
    cameras::StereoFrame frame;
    stage.adjust(lightTaken(options, double(number)),
                 defocus_px(options, double(number), script->frameCount()));
    const double late = rightLate_s(options, double(number)) * options.frames_per_s - moment.right_behind;
    frame.left = picture(0, seed, 0.0, !is_black && fault != CameraFault::black_left);
    frame.right = picture(1, seed, late, !is_black);
    stage.set(moment.cast);  // depth() belongs to the left camera's moment
    if (options.right_time_stamps) frame.right_late_s = rightLate_s(options, double(number));
    if (fault == CameraFault::swapped) std::swap(frame.left, frame.right);
    return frame;
  }

  /// Takes a picture. `late`: frames after the left camera's moment.
  cv::Mat picture(std::size_t camera, std::uint64_t seed, double late, bool is_open) {
    const Shutter shutter{1e-3 * options.rolling_ms, 1e-3 * options.exposure_ms};
    const double when = double(number) + late;
    if (is_open && !shutter.isInstant())
      return stage.sweptPicture(camera, seed, shutter, [&](double later_s) {
        return script->at(std::max(0.0, when + later_s * options.frames_per_s)).cast;
      });
    if (late != 0.0) stage.set(script->at(when).cast);
    return stage.picture(camera, seed, is_open);
  }

  /// Returns the last pair once more, as if it were new; the truth is still that of its pictures.
  std::shared_ptr<const cameras::StereoFrame> lastAgain() {
    auto frame = std::make_shared<cameras::StereoFrame>(last);
    frame->left = last.left.clone(), frame->right = last.right.clone();
    frame->number = truth.frame = number;
    frame->captured = Timestamp{double(number) / options.frames_per_s};
    ++number;
    return frame;
  }

  GroundTruth truthOf(const Moment& moment) const {
    GroundTruth now;
    now.frame = number;
    now.camera_T_mri = stage.camera_T_room() * moment.cast.room_T_mri;
    if (moment.cast.room_T_coil) {
      now.camera_T_coil = stage.camera_T_room() * *moment.cast.room_T_coil;
      now.camera_T_marker = *now.camera_T_coil * stage.coil().marker_T_coil.inverse();
    }
    if (moment.cast.room_T_second && stage.secondCoil())
      now.camera_T_second_marker =
          stage.camera_T_room() * *moment.cast.room_T_second * stage.secondCoil()->marker_T_coil.inverse();
    now.label = moment.label;
    now.is_patient_there = moment.cast.stranger == 0;
    const bool is_shown = moment.fault == CameraFault::none && now.is_patient_there;
    now.face_visible_fraction = is_shown ? stage.faceVisibleFraction() : 0.0;
    now.is_out_of_step = moment.right_behind != 0.0;
    now.must_be_lost = !is_shown || now.face_visible_fraction < 0.05 || now.is_out_of_step;
    now.jaw_mm = moment.cast.jaw_mm;
    now.right_moved << logRotation(moment.cast.right_moved.linear()), moment.cast.right_moved.translation();
    return now;
  }
};

SyntheticSource::SyntheticSource(const ScenarioOptions& options,
                                 std::shared_ptr<const VirtualPatient> patient,
                                 const std::optional<RigidTransform<Mri, frames::Target>>& target)
    : implementation_(
          std::make_unique<Implementation>(options, patient, target ? *target : leftHandArea(*patient))) {}

SyntheticSource::~SyntheticSource() = default;

const cameras::StereoRig& SyntheticSource::rig() const { return implementation_->stage.rig(); }

std::shared_ptr<const cameras::StereoFrame> SyntheticSource::next() {
  auto& all = *implementation_;
  while (all.number + 1 < all.script->frameCount() && isDropped(all.options, all.number)) ++all.number;
  if (all.number >= all.script->frameCount()) return nullptr;
  if (isDoubled(all.options, all.number)) return all.lastAgain();
  const Moment moment = all.script->at(int(all.number));
  all.stage.set(moment.cast);
  all.truth = all.truthOf(moment);
  auto frame = all.photograph(moment);
  frame.number = all.number;
  frame.captured = Timestamp{double(all.number) / all.options.frames_per_s + moment.later_s};
  all.last = {frame.left.clone(), frame.right.clone(), frame.number, frame.captured, frame.right_late_s};
  ++all.number;
  return std::make_shared<const cameras::StereoFrame>(std::move(frame));
}

std::optional<std::int64_t> SyntheticSource::frameCount() const {
  return implementation_->script->frameCount();
}

cameras::StereoFrame SyntheticSource::captureWith(std::optional<stereo::DotPattern> dots) {
  auto& all = *implementation_;
  Cast cast = all.script->capture();
  cast.dots = dots;
  all.stage.set(cast);
  const std::uint64_t seed = all.options.seed * kFramesPerSeed + 900001;
  return all.stage.photograph(0, 0.0, seed + (dots ? 0 : 1));
}

cameras::StereoFrame SyntheticSource::captureWithCoil(int again) {
  auto& all = *implementation_;
  Cast cast = all.script->capture();
  cast.room_T_coil = cast.room_T_mri * all.target.reframe<Mri, Coil>();
  all.stage.set(cast);
  return all.stage.photograph(again, 0.0, all.options.seed * kFramesPerSeed + 900003 + std::uint64_t(again));
}

cameras::StereoFrame SyntheticSource::captureShowing(const cv::Mat& picture) {
  auto& all = *implementation_;
  Cast cast = all.script->capture();
  cast.shown = picture;
  all.stage.set(cast);
  return all.stage.photograph(0, 0.0, all.options.seed * kFramesPerSeed + 900002);
}

cameras::ProjectorModel SyntheticSource::projector() const {
  return roomProjector(implementation_->stage.camera_T_room());
}

capture::CapturePair SyntheticSource::capturePair() {
  capture::CapturePair pair;
  pair.pattern = captureWith(stereo::DotPattern::dense);
  pair.plain = captureWith(std::nullopt);
  return pair;
}

RigidTransform<Camera, Mri> SyntheticSource::captureTruth() const {
  return implementation_->stage.camera_T_room() * implementation_->script->capture().room_T_mri;
}

const GroundTruth& SyntheticSource::truth() const { return implementation_->truth; }

DepthMaps SyntheticSource::depth() const {
  const View &left = implementation_->stage.view(0), &right = implementation_->stage.view(1);
  return {left.depth_mm.clone(), right.depth_mm.clone(), left.object.clone(), right.object.clone()};
}

const RoomCoil& SyntheticSource::coil() const { return implementation_->stage.coil(); }
const std::optional<RoomCoil>& SyntheticSource::secondCoil() const {
  return implementation_->stage.secondCoil();
}
const std::optional<RigidTransform<Mri, frames::Target>>& SyntheticSource::secondTarget() const {
  return implementation_->second_target;
}
const RigidTransform<Mri, frames::Target>& SyntheticSource::target() const { return implementation_->target; }

}  // namespace facenav::room
