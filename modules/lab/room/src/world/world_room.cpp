#include "facenav/room/world_room.h"

#include <algorithm>
#include <cmath>

#include "facenav/geometry/rotation.h"
#include "optics/dot_slide.h"
#include "props/worn.h"
#include "stage.h"
#include "world_view.h"

namespace facenav::room {
namespace {

constexpr std::uint64_t kFramesPerWorld = 1000003;
constexpr double kFirst_s = 0.5;  // from the capture to the first frame

std::array<FilmOptions, 2> filmsOf(const WorldFilm& drawn) {
  std::array<FilmOptions, 2> films;
  for (FilmOptions& film : films) {
    film.blur_px = drawn.blur_px;
    film.noise_grey = drawn.noise_grey;
    film.jpeg_quality = drawn.jpeg_quality;
    film.is_bayer = drawn.is_bayer;
  }
  films[0].gamma = 1.0 / drawn.tone;
  films[1].gamma = 1.0 / (drawn.tone * drawn.right_tone);
  films[0].red_share = drawn.red, films[0].blue_share = drawn.blue;
  films[1].red_share = drawn.right_red, films[1].blue_share = drawn.right_blue;
  return films;
}

Eigen::Isometry3d motionOf(const DrawnFault& fault) {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = expRotation(fault.turn_deg * kRadPerDeg);
  moved.translation() = fault.shift_mm;
  return moved;
}

double timeOf(int number) {
  return kFirst_s + number / kWorldFrames_per_s + (WorldRoom::isSecond(number) ? kWorldGap_s : 0.0);
}

}  // namespace

struct WorldRoom::Implementation {
  World world;
  DrawnFault fault;
  std::shared_ptr<const VirtualPatient> person;
  cameras::StereoRig rig;
  Stage stage;
  std::array<cv::Mat, 2> last;

  Implementation(const World& w, const DrawnFault& f, std::shared_ptr<const VirtualPatient> p)
      : world(w),
        fault(f),
        person(std::move(p)),
        rig(trueRig(w)),
        stage(rig, w.cameras.rig.roll_deg, person, RoomCoil{}, filmsOf(w.film), w.wall) {
    dress();
    setExposure();
  }

  void dress() {
    constexpr float kSkin = 0.42f;
    const WorldPerson& drawn = world.person;
    stage.addProp(neckMesh(*person), makePlainLook(kSkin * person->skin_brightness, 0.03f), Carrier::body);
    stage.addProp(clothesMesh(*person),
                  makeFabricLook(drawn.fabric, drawn.fabric_mm, drawn.fabric_albedo, drawn.fabric_contrast,
                                 drawn.fabric_turn_deg),
                  Carrier::body);
    if (drawn.has_cap)
      stage.addProp(capMesh(*person, drawn.cap_above_brows_mm),
                    makeFabricLook(Pattern::none, 1.0, 1.0 - drawn.fabric_albedo, 0.0, 0.0), Carrier::head);
    if (drawn.long_hair_mm >= 0.0)
      stage.addProp(longHairMesh(*person, drawn.long_hair_mm, drawn.long_hair_aside_deg * kRadPerDeg),
                    makeStrandLook(drawn.hair_albedo), Carrier::head);
  }

  /// Exposes so that the face's mean grey in the left picture is the drawn one.
  void setExposure() {
    stage.set(castAt(0.0, world.capture));
    const View& view = stage.view(0);
    const double mean = std::max(1e-3, cv::mean(view.radiance, view.object == 1)[0]);
    const double exposure = std::pow(world.film.face_grey / 255.0, 1.0 / world.film.tone) / mean;
    stage.expose({exposure, exposure * world.film.right_light});
  }

  RigidTransform<Room, Mri> headAt(double time_s, const WorldMoment& moment) const {
    // A slow swing that starts at the capture, at rest in its place; its highest speed is the drawn one.
    constexpr double kSwing_mm = 8.0;
    const double start = double(world.seed % 7), phase = start + world.speed_mm_s * time_s / kSwing_mm;
    WorldMoment now = moment;
    now.shift_mm +=
        kSwing_mm * (std::sin(phase) - std::sin(start)) * Eigen::Vector3d(1.0, 0.3, 0.5).normalized();
    now.turn_deg.y() += 2.0 * (std::sin(0.7 * phase) - std::sin(0.7 * start));
    return facePose(world, now, person->face_middle);
  }

  Cast castAt(double time_s, const WorldMoment& moment) const {
    Cast cast;
    cast.room_T_mri = headAt(time_s, moment);
    WorldMoment still = moment;
    still.turn_deg.setZero();
    still.shift_mm *= 0.5;
    cast.room_T_body = facePose(world, still, person->face_middle);
    Expression& face = cast.expression;
    face.smile = moment.smile, face.tongue = moment.tongue, face.lips_in = moment.lips_in;
    face.cheeks = moment.cheeks, face.brows = moment.brows, face.blink = moment.blink;
    cast.jaw_mm = moment.jaw_mm;
    cast.gloss = world.person.gloss;
    cast.has_glasses = world.person.has_glasses;
    cast.ambient_scale = world.light.ambient;
    light(cast);
    return cast;
  }

  /// Lamps about the face: the main one as drawn, the second on the other side.
  void light(Cast& cast) const {
    constexpr double kAway_mm = 1500.0;
    const Eigen::Vector3d face_mm = (facePose(world, {}, person->face_middle) * person->face_middle).mm;
    const auto at = [&](double aside_deg, double up_deg) {
      const double aside = aside_deg * kRadPerDeg, up = up_deg * kRadPerDeg;
      return Eigen::Vector3d(face_mm + kAway_mm * Eigen::Vector3d(std::sin(aside) * std::cos(up),
                                                                  -std::sin(up),
                                                                  -std::cos(aside) * std::cos(up)));
    };
    cast.lamps.push_back({at(world.light.lamp_aside_deg, world.light.lamp_up_deg), world.light.lamp});
    if (world.light.second_lamp > 0.0)
      cast.lamps.push_back({at(-0.7 * world.light.lamp_aside_deg - 15.0, 25.0), world.light.second_lamp});
  }

  bool isFaulty(int number) const {
    return fault.kind != WorldFault::none && (fault.is_from_start || isSecond(number));
  }
  static bool isSecond(int number) { return number >= kFirstFrames; }

  /// Applies what changes the scene itself.
  void disturb(int number, Cast& cast) const {
    if (!isFaulty(number)) return;
    if (fault.kind == WorldFault::turned || fault.kind == WorldFault::shifted)
      cast.right_moved = motionOf(fault);
    if (fault.kind == WorldFault::other_person && !fault.is_from_start) cast.stranger = 2 * world.seed + 1;
  }

  cameras::StereoFrame pair(int number, double time_s, const WorldMoment& moment,
                            const std::function<void(Cast&)>& change) {
    const std::uint64_t seed = world.seed * kFramesPerWorld + std::uint64_t(number + 10);
    const bool is_late = fault.kind == WorldFault::out_of_step && isFaulty(number);
    const auto take = [&](std::size_t camera, double at_s) {
      Cast cast = castAt(at_s, moment);
      disturb(number, cast);
      change(cast);
      stage.set(cast);
      return stage.picture(camera, seed);
    };
    cameras::StereoFrame frame;
    frame.right = take(1, time_s + (is_late ? fault.late_s : 0.0));
    frame.left = take(0, time_s);  // last: the truth is the left camera's
    if (fault.kind == WorldFault::swapped && isFaulty(number)) std::swap(frame.left, frame.right);
    return frame;
  }
};

WorldRoom::WorldRoom(const World& world, const DrawnFault& fault,
                     std::shared_ptr<const VirtualPatient> person)
    : implementation_(std::make_unique<Implementation>(world, fault, std::move(person))) {}
WorldRoom::~WorldRoom() = default;

capture::CapturePair WorldRoom::capture() {
  auto& all = *implementation_;
  capture::CapturePair pair;
  pair.plain = all.pair(-1, 0.0, all.world.capture, [](Cast&) {});
  if (!all.world.dots.is_on) return pair;
  const WorldDots& drawn = all.world.dots;
  const auto model = roomProjector(all.stage.camera_T_room());
  const cv::Mat slide = drawDotSlide({drawn.pitch_px, drawn.size_px, drawn.filled, drawn.blur_px},
                                     {model.width_px, model.height_px}, all.world.seed);
  pair.pattern = all.pair(-2, 0.0, all.world.capture, [&](Cast& cast) {
    cast.shown = slide;
    cast.shown_strength = drawn.strength;
    cast.lamp_scale = drawn.room_light;
    cast.ambient_scale *= drawn.room_light;
  });
  return pair;
}

cameras::StereoFrame WorldRoom::frame(int number) {
  auto& all = *implementation_;
  const WorldMoment& moment = isSecond(number) ? all.world.second : all.world.first;
  cameras::StereoFrame frame = all.pair(number, timeOf(number), moment, [](Cast&) {});
  frame.number = number;
  frame.captured = Timestamp{timeOf(number) - kFirst_s};
  const std::array<cv::Mat, 2> now{frame.left, frame.right};
  if (all.fault.kind == WorldFault::frozen && all.isFaulty(number) && !all.last[0].empty()) {
    if (all.fault.frozen_camera != 1) frame.left = all.last[0].clone();
    if (all.fault.frozen_camera != 0) frame.right = all.last[1].clone();
  } else {
    all.last = now;
  }
  return frame;
}

RigidTransform<Camera, Mri> WorldRoom::captureTruth() const {
  const auto& all = *implementation_;
  return all.stage.camera_T_room() * all.headAt(0.0, all.world.capture);
}

RigidTransform<Camera, Mri> WorldRoom::truth(int number) const {
  const auto& all = *implementation_;
  return all.stage.camera_T_room() *
         all.headAt(timeOf(number), isSecond(number) ? all.world.second : all.world.first);
}

double WorldRoom::faceVisibleFraction() const { return implementation_->stage.faceVisibleFraction(); }

RigidTransform<RightCamera, Camera> WorldRoom::right_T_left(int number) const {
  const auto& all = *implementation_;
  const bool is_moved =
      all.isFaulty(number) && (all.fault.kind == WorldFault::turned || all.fault.kind == WorldFault::shifted);
  if (!is_moved) return all.rig.right_T_left;
  return RigidTransform<RightCamera, Camera>::fromIsometry(motionOf(all.fault) *
                                                           all.rig.right_T_left.isometry());
}

}  // namespace facenav::room
