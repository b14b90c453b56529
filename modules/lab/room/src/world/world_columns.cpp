#include "facenav/core/number_text.h"
#include "facenav/room/world.h"

namespace facenav::room {
namespace {

std::string nameOf(Pattern pattern) {
  switch (pattern) {
    case Pattern::stripes:
      return "stripes";
    case Pattern::checks:
      return "checks";
    case Pattern::spots:
      return "spots";
    case Pattern::none:
      break;
  }
  return "none";
}

}  // namespace

std::string nameOf(WorldFault fault) {
  switch (fault) {
    case WorldFault::none:
      break;
    case WorldFault::out_of_step:
      return "out_of_step";
    case WorldFault::swapped:
      return "swapped";
    case WorldFault::turned:
      return "turned";
    case WorldFault::shifted:
      return "shifted";
    case WorldFault::other_rig:
      return "other_rig";
    case WorldFault::other_person:
      return "other_person";
    case WorldFault::mirrored:
      return "mirrored";
    case WorldFault::frozen:
      return "frozen";
  }
  return "none";
}

const std::vector<WorldFault>& worldFaults() {
  static const std::vector<WorldFault> all{
      WorldFault::out_of_step, WorldFault::swapped,      WorldFault::turned,   WorldFault::shifted,
      WorldFault::other_rig,   WorldFault::other_person, WorldFault::mirrored, WorldFault::frozen};
  return all;
}

std::vector<std::pair<std::string, std::string>> columnsOf(const World& world) {
  const auto& rig = world.cameras.rig;
  const auto& person = world.person;
  const auto whole = [](double value) { return fixed(value, 0); };
  return {{"width_px", std::to_string(rig.width_px)},
          {"height_px", std::to_string(rig.height_px)},
          {"focal_px", whole(rig.focal_px)},
          {"baseline_mm", whole(rig.baseline_mm)},
          {"convergence_deg", fixed(rig.convergence_deg, 1)},
          {"distance_mm", whole(world.cameras.distance_mm)},
          {"face_px", whole(world.cameras.face_px)},
          {"corner_px", fixed(world.cameras.corner_px, 2)},
          {"board_share", fixed(world.cameras.board_share, 2)},
          {"noise_grey", fixed(world.film.noise_grey, 1)},
          {"blur_px", fixed(world.film.blur_px, 2)},
          {"jpeg", std::to_string(world.film.jpeg_quality)},
          {"tone", fixed(world.film.tone, 2)},
          {"face_grey", whole(world.film.face_grey)},
          {"right_light", fixed(world.film.right_light, 2)},
          {"bayer", world.film.is_bayer ? "1" : "0"},
          {"lamp_aside_deg", whole(world.light.lamp_aside_deg)},
          {"lamp", fixed(world.light.lamp, 2)},
          {"ambient", fixed(world.light.ambient, 2)},
          {"window", world.wall.windows.empty() ? "0" : "1"},
          {"wallpaper", nameOf(world.wall.pattern)},
          {"dots", world.dots.is_on ? "1" : "0"},
          {"dot_pitch_px", fixed(world.dots.pitch_px, 1)},
          {"dot_strength", fixed(world.dots.strength, 2)},
          {"dot_blur_px", fixed(world.dots.blur_px, 2)},
          {"dot_room_light", fixed(world.dots.room_light, 2)},
          {"child", person.is_child ? "1" : "0"},
          {"size", fixed(person.scale.mean(), 3)},
          {"skin_contrast", fixed(person.skin_contrast, 2)},
          {"skin_brightness", fixed(person.skin_brightness, 2)},
          {"gloss", fixed(person.gloss, 2)},
          {"glasses", person.has_glasses ? "1" : "0"},
          {"cap", person.has_cap ? "1" : "0"},
          {"beard_mm", fixed(person.beard_mm, 1)},
          {"long_hair", person.long_hair_mm >= 0.0 ? "1" : "0"},
          {"clothes", nameOf(person.fabric)},
          {"seat_turn_deg", whole(world.seat_turn_deg.norm())},
          {"face_at_capture", world.capture.face},
          {"face_first", world.first.face},
          {"face_second", world.second.face},
          {"second_turn_deg", fixed(world.second.turn_deg.norm(), 1)},
          {"second_shift_mm", fixed(world.second.shift_mm.norm(), 1)},
          {"speed_mm_s", whole(world.speed_mm_s)}};
}

}  // namespace facenav::room
