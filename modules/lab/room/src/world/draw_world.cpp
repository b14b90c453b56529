#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/geometry/rotation.h"
#include "facenav/room/world.h"
#include "script/dice.h"
#include "world_view.h"

namespace facenav::room {
namespace {

double logBetween(Dice& dice, double low, double high) {
  return std::exp(dice.between(std::log(low), std::log(high)));
}
bool chance(Dice& dice, double share) { return dice.between(0.0, 1.0) < share; }

struct PictureSize {
  int width_px, height_px;
  double weight;
};
// Rendering takes time in proportion to the pixels, so large pictures are rare.
constexpr std::array<PictureSize, 9> kSizes{{{640, 480, 4.0},
                                             {800, 600, 1.0},
                                             {1024, 768, 1.0},
                                             {1280, 720, 4.0},
                                             {1280, 960, 1.0},
                                             {1024, 1024, 1.0},
                                             {1920, 1080, 2.0},
                                             {2592, 1944, 0.2},
                                             {3840, 2160, 0.2}}};

PictureSize drawSize(Dice& dice) {
  double total = 0.0;
  for (const auto& size : kSizes) total += size.weight;
  double left = dice.between(0.0, total);
  for (const auto& size : kSizes)
    if ((left -= size.weight) < 0.0) return size;
  return kSizes.back();
}

/// True if the distortion grows with the radius up to the corners and a little beyond.
bool isLensPlain(const RigOptions& rig) {
  const double corner = 0.6 * std::hypot(rig.width_px, rig.height_px) / rig.focal_px;
  for (double r = 0.1; r < 1.3 * corner; r += 0.05) {
    const double r2 = r * r;
    if (1.0 + 3.0 * rig.k1 * r2 + 5.0 * rig.k2 * r2 * r2 + 7.0 * rig.k3 * r2 * r2 * r2 < 0.3) return false;
  }
  return true;
}

WorldCameras drawCameras(Dice& dice) {
  WorldCameras cameras;
  RigOptions& rig = cameras.rig;
  const auto size = drawSize(dice);
  rig.width_px = size.width_px, rig.height_px = size.height_px;
  rig.focal_px = logBetween(dice, 400.0, 2500.0);
  rig.baseline_mm = logBetween(dice, 60.0, 300.0);
  rig.convergence_deg = dice.between(0.0, 25.0);
  rig.roll_deg = chance(dice, 0.15) ? dice.between(-20.0, 20.0) : dice.between(-4.0, 4.0);
  rig.k1 = dice.between(-0.35, 0.08);
  rig.k2 = -0.5 * rig.k1 + dice.between(-0.03, 0.03);
  rig.k3 = dice.between(-0.02, 0.02);
  rig.p1 = dice.between(-0.001, 0.001), rig.p2 = dice.between(-0.001, 0.001);
  cameras.distance_mm = logBetween(dice, 350.0, 1500.0);
  const double half_view_mm = 0.5 * cameras.distance_mm / rig.focal_px;
  cameras.face_at_mm = {dice.between(-0.5, 0.5) * rig.width_px * half_view_mm,
                        dice.between(-0.4, 0.6) * rig.height_px * half_view_mm};
  cameras.face_px = 145.0 * rig.focal_px / cameras.distance_mm;
  cameras.board_views = int(dice.between(10.0, 25.0));
  cameras.corner_px = logBetween(dice, 0.04, 0.3);
  cameras.board_share = dice.between(0.55, 0.95);
  return cameras;
}

WorldFilm drawFilm(Dice& dice) {
  WorldFilm film;
  film.noise_grey = logBetween(dice, 0.5, 6.0);
  film.blur_px = logBetween(dice, 0.35, 1.6);
  film.tone = dice.between(0.45, 1.0);
  film.jpeg_quality = chance(dice, 0.25) ? 0 : int(std::lround(dice.between(30.0, 95.0)));
  film.face_grey = dice.between(60.0, 180.0);
  film.right_light = chance(dice, 0.5) ? dice.between(0.95, 1.05) : dice.between(0.5, 1.0);
  if (chance(dice, 0.5)) film.right_light = 1.0 / film.right_light;
  film.right_tone = dice.between(0.9, 1.1);
  film.red = dice.between(0.2, 0.45), film.blue = dice.between(0.05, 0.35);
  film.right_red = film.red + dice.between(-0.05, 0.05);
  film.right_blue = film.blue + dice.between(-0.05, 0.05);
  film.is_bayer = chance(dice, 0.3);
  if (chance(dice, 0.3)) film.red = film.blue = 1.0 / 3.0;  // one camera, or both, is grey
  if (chance(dice, 0.3)) film.right_red = film.right_blue = 1.0 / 3.0;
  return film;
}

WorldLight drawLight(Dice& dice) {
  WorldLight light;
  light.lamp_aside_deg = dice.between(-80.0, 80.0);
  light.lamp_up_deg = dice.between(-5.0, 65.0);
  light.lamp = dice.between(0.15, 0.8);
  light.second_lamp = chance(dice, 0.4) ? 0.0 : dice.between(0.0, 0.5);
  light.ambient = logBetween(dice, 0.25, 1.6);
  return light;
}

WorldDots drawDots(Dice& dice) {
  WorldDots dots;
  dots.is_on = chance(dice, 0.6);
  dots.pitch_px = logBetween(dice, 4.0, 16.0);
  dots.size_px = std::max(1.0, dots.pitch_px * dice.between(0.2, 0.5));
  dots.filled = dice.between(0.5, 1.0);
  dots.strength = logBetween(dice, 0.2, 1.5);
  dots.blur_px = logBetween(dice, 0.3, 2.5);
  dots.room_light = dice.between(0.1, 1.0);
  return dots;
}

Pattern drawPattern(Dice& dice, double none) {
  if (chance(dice, none)) return Pattern::none;
  constexpr Pattern kAll[] = {Pattern::stripes, Pattern::checks, Pattern::spots};
  return kAll[int(dice.between(0.0, 2.999))];
}

WorldPerson drawPerson(Dice& dice) {
  WorldPerson person;
  person.head = dice.between(0.0, 1.0);
  person.is_child = chance(dice, 0.2);
  const double size = person.is_child ? dice.between(0.80, 0.95) : dice.between(0.95, 1.06);
  for (int axis = 0; axis < 3; ++axis) person.scale[axis] = size * dice.between(0.96, 1.04);
  person.soft_mm = dice.between(0.0, 1.3);
  person.tissue = std::uint64_t(dice.between(0.0, 1e6));
  person.is_mirrored = chance(dice, 0.5);
  person.skin_contrast = logBetween(dice, 0.12, 1.5);
  person.skin_brightness = dice.between(0.35, 1.3);
  person.gloss = chance(dice, 0.5) ? 0.0 : dice.between(0.0, 1.0);
  person.is_bald = chance(dice, 0.12);
  person.has_glasses = chance(dice, 0.25);
  person.has_cap = chance(dice, 0.12);
  person.cap_above_brows_mm = dice.between(15.0, 40.0);
  person.beard_mm = !person.is_child && chance(dice, 0.25) ? dice.between(1.0, 10.0) : 0.0;
  person.long_hair_mm = !person.is_bald && chance(dice, 0.25) ? dice.between(0.0, 150.0) : -1.0;
  person.long_hair_aside_deg = dice.between(52.0, 80.0);
  person.hair_albedo = float(logBetween(dice, 0.04, 0.35));
  person.fabric = drawPattern(dice, 0.4);
  person.fabric_mm = logBetween(dice, 8.0, 60.0);
  person.fabric_albedo = dice.between(0.08, 0.6);
  person.fabric_contrast = dice.between(0.15, 0.8);
  person.fabric_turn_deg = chance(dice, 0.5) ? 90.0 * int(dice.between(0.0, 1.999)) : dice.between(0.0, 90.0);
  return person;
}

RoomWall drawWall(Dice& dice, double distance_mm) {
  RoomWall wall;
  wall.distance_mm = distance_mm + logBetween(dice, 400.0, 3000.0);
  wall.pattern = drawPattern(dice, 0.5);
  wall.pattern_mm = logBetween(dice, 20.0, 300.0);
  wall.pattern_contrast = dice.between(0.1, 0.7);
  wall.turn_deg = chance(dice, 0.5) ? 0.0 : dice.between(0.0, 90.0);
  if (!chance(dice, 0.3)) return wall;
  RoomWindow window;
  window.low_mm = {dice.between(-1500.0, 600.0), dice.between(-1200.0, -200.0)};
  window.high_mm = window.low_mm + Eigen::Vector2d(dice.between(400.0, 1200.0), dice.between(500.0, 1500.0));
  window.radiance = logBetween(dice, 0.6, 6.0);
  wall.windows.push_back(window);
  return wall;
}

void drawFace(Dice& dice, WorldMoment& moment) {
  struct Drawn {
    const char* name;
    double WorldMoment::*part;
  };
  constexpr std::array<Drawn, 5> kDrawn{{{"smile", &WorldMoment::smile},
                                         {"tongue", &WorldMoment::tongue},
                                         {"lips in", &WorldMoment::lips_in},
                                         {"cheeks", &WorldMoment::cheeks},
                                         {"brows", &WorldMoment::brows}}};
  const int kind = int(dice.between(0.0, 7.999));
  const double strength = dice.between(0.3, 1.0);
  moment.brows = dice.between(-0.4, 0.5);
  if (kind < 5) {
    moment.face = kDrawn[std::size_t(kind)].name;
    moment.*kDrawn[std::size_t(kind)].part = strength;
  } else if (kind == 5) {
    moment.face = "jaw";
    moment.jaw_mm = 11.0 * strength;
  } else {
    moment.brows = 0.0;
  }
  moment.blink = chance(dice, 0.1) ? 1.0 : 0.0;
}

/// A pose away from the seat; it comes nearer until both pictures show the face.
void drawPlace(Dice& dice, const World& world, double most_deg, double most_mm, WorldMoment& moment) {
  moment.turn_deg = logBetween(dice, 0.05 * most_deg, most_deg) * dice.direction();
  moment.shift_mm = logBetween(dice, 0.05 * most_mm, most_mm) * dice.direction();
  while (!isFaceInView(world, moment) && moment.shift_mm.norm() > 0.1)
    moment.turn_deg *= 0.8, moment.shift_mm *= 0.8;
}

}  // namespace

World drawWorld(std::uint64_t seed) {
  Dice dice(seed * 6364136223846793005ull + 1442695040888963407ull);
  for (int i = 0; i < 8; ++i) dice.between(0.0, 1.0);
  World world;
  world.seed = seed;
  do {
    world.cameras = drawCameras(dice);
    world.seat_turn_deg = {dice.between(-10.0, 10.0), dice.between(-20.0, 20.0), dice.between(-8.0, 8.0)};
  } while (world.cameras.face_px < kLeastFace_px || !isLensPlain(world.cameras.rig) ||
           !isFaceInView(world, {}));
  world.film = drawFilm(dice);
  world.light = drawLight(dice);
  world.dots = drawDots(dice);
  world.person = drawPerson(dice);
  world.wall = drawWall(dice, world.cameras.distance_mm);
  drawFace(dice, world.capture);
  world.first = world.capture;
  if (chance(dice, 0.5)) {
    world.first = {};
    drawFace(dice, world.first);
  }
  drawPlace(dice, world, 3.0, 10.0, world.first);
  drawFace(dice, world.second);
  drawPlace(dice, world, 15.0, 60.0, world.second);
  world.speed_mm_s = logBetween(dice, 1.0, 60.0);
  return world;
}

DrawnFault drawFault(World& world, WorldFault kind) {
  Dice dice(world.seed * 2862933555777941757ull + std::uint64_t(kind) * 3037000493ull + 7);
  for (int i = 0; i < 8; ++i) dice.between(0.0, 1.0);
  DrawnFault fault;
  fault.kind = kind;
  fault.is_from_start = chance(dice, 0.5);
  switch (kind) {
    case WorldFault::out_of_step:
      fault.late_s = logBetween(dice, 0.01, 0.5);
      fault.size = 1e3 * fault.late_s;
      world.speed_mm_s = logBetween(dice, 20.0, 120.0);
      break;
    case WorldFault::turned:
      fault.size = logBetween(dice, 0.05, 2.0);
      fault.turn_deg = fault.size * dice.direction();
      break;
    case WorldFault::shifted:
      fault.size = logBetween(dice, 0.3, 10.0);
      fault.shift_mm = fault.size * dice.direction();
      break;
    case WorldFault::frozen:
      fault.is_from_start = false;
      fault.frozen_camera = int(dice.between(0.0, 2.999));
      world.speed_mm_s = logBetween(dice, 20.0, 120.0);
      break;
    case WorldFault::other_rig:
    case WorldFault::mirrored:
      fault.is_from_start = true;
      break;
    default:
      break;
  }
  return fault;
}

}  // namespace facenav::room
