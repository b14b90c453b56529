#pragma once
// Scenario: the events in the virtual treatment room, chosen by name. The same options and seed give the same
// images. A scenario may have its own values (cameras, light, skin); they apply to options that have their
// default value.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/field.h"
#include "facenav/core/task_monitor.h"
#include "facenav/room/room_coil.h"
#include "facenav/room/room_rig.h"
#include "facenav/room/virtual_patient.h"

namespace facenav::room {

struct ScenarioOptions {
  std::string name = "treatment";
  int frames = 0;  // 0: the scenario's length
  double frames_per_s = 60.0;
  std::uint64_t seed = 1;
  double head_distance_mm = 600.0;  // from the cameras to the face
  double noise_grey = 1.5, blur_px = 0.6, exposure = 1.3, gamma = 1.0;
  double motion = 1.0;  // scales the scenario's head motion
  int coils = 1;        // 2: "treatment" brings a second coil to the other side of the head
  double seat_turn_deg = 0.0, seat_shift_mm = 0.0;  // limits of the seat's random error
  double right_late_ms = 0.0;  // delay of the right camera's exposure; the truth is that of the left
  double rolling_ms = 0.0, exposure_ms = 0.0;  // rolling shutter: readout of a picture; exposure of a row
  double stated_row_time = 1.0;         // row time in the rig's file, as a multiple of the true one; 0: not
                                        // given
  double exposure_step = 0.0;           // of automatic exposure: share of the light
  double refocus_px = 0.0;              // blur while both cameras focus anew
  double clock_ppm = 0.0;               // clock error of the right camera (> 0: it runs late)
  double dropped = 0.0, doubled = 0.0;  // share of the pairs
  int right_time_stamps = 0;            // 1: the drivers give the right camera's delay
  int jpeg_quality = -1;                // 1..100; 0: not compressed; -1: the scenario's value
  double gloss = -1.0;                  // of the skin; -1: the scenario's value
  double haze_grey = 0.0;
  double right_gain = 1.0, right_gamma = 1.0;          // of the right camera, relative to the left one
  int blinks = -1;                                     // 1: blinks; 0: none; -1: the scenario's value
  double hair_sway_mm = -1.0;                          // 0: hair does not move; -1: the scenario's value
  double capture_grimace = 0.0;                        // size of a grimace at the capture alone; 0: none
  double skin_contrast = 1.0;                          // scales the contrast of the patient's skin
  int bayer = -1;                                      // 1: colour sensors; -1: the scenario's value
  double grey_red = 1.0 / 3.0, grey_blue = 1.0 / 3.0;  // weights of red and blue in the left camera's grey
  double right_grey_red = 1.0 / 3.0, right_grey_blue = 1.0 / 3.0;
  double drift_deg = 0.3, drift_mm = 1.0;  // motion of the right camera over "drift"
  std::string drift_about;                 // "yaw", "pitch", "roll", "shift"; empty: in turn with the seed
  std::string rig_name;                    // "room", "close", "720p", "1080p"; empty: the scenario's rig
  RigOptions rig;                          // changes to the named rig: options that differ from their default

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitSequence(self, visitor);
    visitSensor(self, visitor);
    visitImages(self, visitor);
    visitPatient(self, visitor);
    visitColour(self, visitor);
    visitRig(self, visitor);
    RigOptions::visit(self.rig, visitor);
  }

 private:
  template <class Self, class Visitor>
  static void visitSequence(Self& self, Visitor&& visitor) {
    visitor(Field{"frames", "number of frames (0: the scenario's own length)", 0, 100000}, self.frames);
    visitor(Field{"frames_per_s", "frame rate", 1, 1000}, self.frames_per_s);
    visitor(Field{"seed", "of motion, skin and noise"}, self.seed);
    visitor(Field{"head_distance_mm", "from the cameras to the face", 200, 3000}, self.head_distance_mm);
    visitor(Field{"noise_grey", "standard deviation of the sensor noise, grey levels", 0, 50},
            self.noise_grey);
    visitor(Field{"blur_px", "standard deviation of the lens blur", 0, 10}, self.blur_px);
    visitor(Field{"exposure", "of both cameras", 0.01, 100}, self.exposure);
    visitor(Field{"gamma", "of the cameras' tone curve", 0.2, 5}, self.gamma);
    visitor(Field{"motion", "scales the head's motion", 0, 5}, self.motion);
    visitor(Field{"coils", "treatment: 2: a second coil, marker id 8, is brought to the other side", 1, 2},
            self.coils);
    visitor(Field{"seat_turn_deg", "the seed turns the seated patient by up to this, about any axis", 0, 60},
            self.seat_turn_deg);
    visitor(Field{"seat_shift_mm", "and shifts by up to this, in any direction", 0, 300}, self.seat_shift_mm);
    visitor(
        Field{"right_late_ms",
              "by how much the right camera exposes after the left one (free-running cameras)", -100, 100},
        self.right_late_ms);
  }
  template <class Self, class Visitor>
  static void visitImages(Self& self, Visitor&& visitor) {
    visitor(Field{"jpeg_quality",
                  "images are JPEG of this quality (0: not compressed, -1: the scenario's own)", -1, 100},
            self.jpeg_quality);
    visitor(Field{"gloss",
                  "sheen of the skin, other in each camera: 0 none, 1 shines, -1: the scenario's own", -1, 3},
            self.gloss);
    visitor(Field{"haze_grey", "veiling glare: grey levels added, with a gradient over the image", 0, 200},
            self.haze_grey);
    visitor(Field{"right_gain", "light that the right camera takes, relative to the left one", 0.05, 20},
            self.right_gain);
    visitor(Field{"right_gamma", "of the right camera's tone curve, relative to the left one's", 0.2, 5},
            self.right_gamma);
  }
  template <class Self, class Visitor>
  static void visitPatient(Self& self, Visitor&& visitor) {
    visitor(Field{"blinks", "the patient blinks: 1 yes, 0 no, -1: as the scenario says", -1, 1}, self.blinks);
    visitor(
        Field{"hair_sway_mm",
              "how far hair moves against the skull; adds locks at the hairline (0: it stays, none; -1: as "
              "the scenario says)",
              -1, 20},
        self.hair_sway_mm);
    visitor(Field{"capture_grimace",
                  "size of a grimace at the capture, which the seed chooses; the face is at rest afterwards",
                  0, 1},
            self.capture_grimace);
    visitor(Field{"skin_contrast", "scales blotches, freckles and pores of whoever sits there", 0, 3},
            self.skin_contrast);
  }
  template <class Self, class Visitor>
  static void visitColour(Self& self, Visitor&& visitor) {
    visitor(
        Field{"bayer",
              "colour cameras (RGGB mosaic), demosaiced and turned grey: 1 yes, 0 no, -1: as the scenario "
              "says",
              -1, 1},
        self.bayer);
    visitor(Field{"grey_red", "share of red in the left camera's grey; green has the rest", 0, 1},
            self.grey_red);
    visitor(Field{"grey_blue", "share of blue in it", 0, 1}, self.grey_blue);
    visitor(Field{"right_grey_red", "share of red in the right camera's grey", 0, 1}, self.right_grey_red);
    visitor(Field{"right_grey_blue", "share of blue in it", 0, 1}, self.right_grey_blue);
  }
  template <class Self, class Visitor>
  static void visitRig(Self& self, Visitor&& visitor) {
    visitor(Field{"drift_deg", "drift: turn of the right camera from the first frame to the last", 0, 5},
            self.drift_deg);
    visitor(Field{"drift_mm", "drift: its shift, where drift_about is shift", 0, 20}, self.drift_mm);
    visitor(Field{"drift_about",
                  "drift: yaw (the camera's vertical axis), pitch, roll or shift; empty: in turn with the "
                  "seed, from yaw at 1"},
            self.drift_about);
    visitor(
        Field{
            "rig",
            "cameras: room (the default ones), close (near the face: 1024 x 1024, f 1550 px, 114 mm "
            "and 20 deg apart, head at 560 mm), 720p, 1080p (webcams of this size, 62 deg across); empty: as "
            "the scenario says"},
        self.rig_name);
  }
  template <class Self, class Visitor>
  static void visitSensor(Self& self, Visitor&& visitor) {
    visitor(Field{"rolling_ms", "rolling shutter: time from the first row to the last", 0, 100},
            self.rolling_ms);
    visitor(
        Field{"stated_row_time",
              "rolling shutter: the row time that stereo.yml states, as a multiple of the true one (0: none)",
              -5, 5},
        self.stated_row_time);
    visitor(Field{"exposure_ms", "exposure of a row: what moves is blurred", 0, 100}, self.exposure_ms);
    visitor(Field{"exposure_step",
                  "automatic exposure: every second the light that both cameras take goes up or down by this "
                  "share, within five frames",
                  0, 1},
            self.exposure_step);
    visitor(Field{"refocus_px", "in the middle third both cameras lose focus by this blur and find it again",
                  0, 10},
            self.refocus_px);
    visitor(Field{"clock_ppm", "by how much the right camera's clock runs late, millionths", -5000, 5000},
            self.clock_ppm);
    visitor(Field{"dropped", "share of the pairs that do not arrive", 0, 0.5}, self.dropped);
    visitor(Field{"doubled", "share of the pairs in whose place the last one arrives again", 0, 0.5},
            self.doubled);
    visitor(Field{"right_time_stamps", "1: the cameras' drivers state the right camera's delay", 0, 1},
            self.right_time_stamps);
  }
};

struct ScenarioKind {
  std::string name, help;
  int frames;            // default length
  int jpeg_quality = 0;  // its own compression and gloss
  double gloss = 0.0;
  bool blinks = false;
  bool is_real = false;  // mimics a real face in front of two near colour cameras
};

/// Scenario of one seated patient with every kind of input that an alignment can start from.
constexpr const char* kPlainAlign = "plain_align";

/// Lists all scenarios.
const std::vector<ScenarioKind>& scenarios();
/// Returns the options after the scenario's own values replaced the defaults. Throws Error for an unknown
/// scenario or rig; the message lists the known ones.
ScenarioOptions resolved(ScenarioOptions options);

}  // namespace facenav::room
