#pragma once
// World: one whole set-up drawn by a seed, far beyond the rooms of scenario.h: cameras, light, a person with
// clothes, the wall, a projector, and the head's motion between moments. Angles in deg, lengths in mm, Room's
// axes (x right, y down, z to the patient).

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "facenav/room/person_shape.h"
#include "facenav/room/room_rig.h"
#include "facenav/room/room_wall.h"

namespace facenav::room {

struct WorldCameras {
  RigOptions rig;
  double distance_mm = 600.0;                            // from the rig to the face
  Eigen::Vector2d face_at_mm = Eigen::Vector2d::Zero();  // the face, beside Room's z axis
  double face_px = 0.0;                                  // width of a face of 145 mm there
  // The calibration: views of a board, standard error of a corner, and the share of the picture (from its
  // middle) that the board was shown in.
  int board_views = 16;
  double corner_px = 0.1, board_share = 0.8;
};

struct WorldFilm {
  double noise_grey = 1.5, blur_px = 0.6, tone = 1.0;  // grey = 255 light^tone
  int jpeg_quality = 0;                                // 0: not compressed
  double face_grey = 110.0;                            // mean of the face in the left picture
  double right_light = 1.0, right_tone = 1.0;          // of the right camera, relative to the left one
  double red = 1.0 / 3.0, blue = 1.0 / 3.0, right_red = 1.0 / 3.0, right_blue = 1.0 / 3.0;
  bool is_bayer = false;
};

struct WorldLight {
  double lamp_aside_deg = 0.0, lamp_up_deg = 30.0;  // of the main lamp, as seen from the face
  double lamp = 0.5, second_lamp = 0.2, ambient = 1.0;
};

struct WorldDots {
  bool is_on = true;
  double pitch_px = 6.0, size_px = 2.0, filled = 1.0;  // on the projector's slide; share of places with a dot
  double strength = 1.0, blur_px = 0.4;
  double room_light = 0.5;  // share of the room's light that stays on
};

struct WorldPerson {
  double head = 0.0;  // 0..1: which of the heads
  bool is_child = false;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  double soft_mm = 0.0;
  std::uint64_t tissue = 0;
  bool is_mirrored = false;  // the portrait's sides are exchanged
  double skin_contrast = 1.0, skin_brightness = 1.0, gloss = 0.0;
  bool is_bald = false, has_glasses = false, has_cap = false;
  double beard_mm = 0.0, cap_above_brows_mm = 25.0;
  double long_hair_mm = -1.0, long_hair_aside_deg = 60.0;  // below the chin; < 0: none
  float hair_albedo = 0.1f;
  Pattern fabric = Pattern::none;
  double fabric_mm = 20.0, fabric_albedo = 0.3, fabric_contrast = 0.0, fabric_turn_deg = 0.0;
};

/// Face and head at one moment: a grimace, and the pose relative to the seat.
struct WorldMoment {
  std::string face = "rest";
  double smile = 0, tongue = 0, lips_in = 0, cheeks = 0, brows = 0, blink = 0, jaw_mm = 0;
  Eigen::Vector3d turn_deg = Eigen::Vector3d::Zero(), shift_mm = Eigen::Vector3d::Zero();
};

struct World {
  std::uint64_t seed = 0;
  WorldCameras cameras;
  WorldFilm film;
  WorldLight light;
  WorldDots dots;
  WorldPerson person;
  RoomWall wall;
  Eigen::Vector3d seat_turn_deg = Eigen::Vector3d::Zero();  // from looking straight at the rig's middle
  WorldMoment capture, first, second;                       // second: after the gap
  double speed_mm_s = 5.0;                                  // highest speed of the head within a moment
};

/// What is wrong in a trial.
enum class WorldFault {
  none,
  out_of_step,   // the right camera exposes later while the head moves
  swapped,       // left and right exchanged
  turned,        // the right camera turned since the calibration
  shifted,       // the right camera shifted since the calibration
  other_rig,     // the calibration is another rig's
  other_person,  // aligned to one, another in view
  mirrored,      // the scan's left and right are exchanged
  frozen,        // a camera repeats its picture
};

/// A fault with its size.
struct DrawnFault {
  WorldFault kind = WorldFault::none;
  bool is_from_start = true;  // in the capture too; else from the second moment on
  double late_s = 0.0;
  Eigen::Vector3d turn_deg = Eigen::Vector3d::Zero(), shift_mm = Eigen::Vector3d::Zero();
  int frozen_camera = 1;  // 0 left, 1 right, 2 both
  double size = 0.0;      // late ms, turn deg or shift mm; 0: none
};

/// Draws the world of a seed: the same seed gives the same world on every machine. The face lies in both
/// pictures at every moment and is at least kLeastFace_px wide.
World drawWorld(std::uint64_t seed);
constexpr double kLeastFace_px = 85.0;

/// Draws the fault's size in this world. out_of_step also changes the head's speed: it moves.
DrawnFault drawFault(World& world, WorldFault kind);
/// Word of a fault: "out_of_step".
std::string nameOf(WorldFault fault);
/// All faults, without none.
const std::vector<WorldFault>& worldFaults();
/// The world's parameters by name, for a table.
std::vector<std::pair<std::string, std::string>> columnsOf(const World& world);

/// The shape that the world gives a head; the scan's skin takes the same one.
PersonShape shapeOf(const World& world, const VirtualPatient& head);
/// The person in the room.
VirtualPatient personOf(const World& world, const VirtualPatient& head);

}  // namespace facenav::room
