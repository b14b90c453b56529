#pragma once
// Stage: the room with all its objects. A scenario sets their state (Cast); the stage renders a stereo pair
// with its truth.

#include <array>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/room/room_coil.h"
#include "facenav/room/room_rig.h"
#include "facenav/room/room_wall.h"
#include "facenav/room/virtual_patient.h"
#include "facenav/stereo/dot_pattern.h"
#include "optics/film.h"
#include "optics/renderer.h"
#include "patient/expression.h"
#include "patient/hair_pose.h"

namespace facenav::room {

/// Shutter of a camera without a global one: exposes row by row.
struct Shutter {
  double rolling_s = 0.0;   // from the first row to the last
  double exposure_s = 0.0;  // of each row
  bool isInstant() const { return rolling_s == 0.0 && exposure_s == 0.0; }
};

/// A lamp in place of the room's usual ones, Room.
struct RoomLamp {
  Eigen::Vector3d place_mm;
  double intensity = 0.5;  // 1: a white sheet facing it, 1.5 m away, has full light
  bool operator==(const RoomLamp& other) const {
    return place_mm == other.place_mm && intensity == other.intensity;
  }
};

/// What carries a prop.
enum class Carrier { head, body };

/// One moment in the room.
struct Cast {
  RigidTransform<Room, Mri> room_T_mri;
  std::optional<RigidTransform<Room, Coil>> room_T_coil, room_T_second;  // second: Stage::addSecondCoil
  std::optional<Eigen::Isometry3d> room_T_hand;                          // a hand that hides part of the face
  double lamp_scale = 1.0, ambient_scale = 1.0;
  Eigen::Vector3d lamp_shift_mm = Eigen::Vector3d::Zero();  // Room
  std::optional<stereo::DotPattern> dots;                   // projected; empty: the projector is off
  cv::Mat
      shown;  // 8-bit, in place of the dots: what the projector shows, of roomProjector()'s size; not dimmed
  double shown_strength = 1.0;                           // scales the projector's light for `shown`
  std::vector<RoomLamp> lamps;                           // empty: the usual two
  std::optional<RigidTransform<Room, Mri>> room_T_body;  // carries clothes; empty: they are not shown
  double wetness = 0.0;                                  // of the skin: 1: small hard highlights
  double gloss = 0.0;               // sheen of the skin, different in each camera: 1: shiny
  bool has_mask = false;            // surgical mask over nose and mouth
  bool has_glasses = false;         // a dark frame before the eyes, without glint
  std::uint64_t stranger = 0;       // number of another person who replaces the patient; 0: the patient
  double jaw_mm = 0.0, lids = 0.0;  // how far the chin is lowered; 0 eyes open .. 1 closed
  Expression expression;            // of the person present
  HairPose hair;                    // of the person present
  /// Motion of the right camera on its mount since the calibration, in its own frame: moved from calibrated.
  Eigen::Isometry3d right_moved = Eigen::Isometry3d::Identity();

  /// Compares every detail: equal casts give the same images.
  bool operator==(const Cast& other) const;
};

class Stage {
 public:
  Stage(const cameras::StereoRig& rig, double rig_roll_deg, std::shared_ptr<const VirtualPatient> patient,
        const RoomCoil& coil, const std::array<FilmOptions, 2>& films, const RoomWall& wall = {});
  ~Stage();

  /// Adds something that the patient wears, in Mri; not worn by a stranger.
  void addProp(const surface::TriangleMesh& mesh, std::shared_ptr<const Look> look, Carrier carrier);
  /// Adds a second coil, with a marker of its own.
  void addSecondCoil(const RoomCoil& coil);
  /// Sets the exposure of both films.
  void expose(const std::array<double, 2>& exposures);

  void set(const Cast& cast);
  /// Image of the left (0) or right (1) camera in linear light, with depth and object maps. Rendered once
  /// until another cast is set.
  const View& view(std::size_t camera) const;
  /// Takes the image of one camera. A closed shutter gives black with noise.
  cv::Mat picture(std::size_t camera, std::uint64_t noise_seed, bool is_open = true) const;
  /// Takes the image with this shutter. `at`: the cast so many seconds after the picture's middle row is half
  /// exposed. The last cast stays set.
  cv::Mat sweptPicture(std::size_t camera, std::uint64_t noise_seed, const Shutter& shutter,
                       const std::function<Cast(double later_s)>& at);
  /// Sets for both films the light that they take, and blur (px) beside the lens's own.
  void adjust(double light, double defocus_px);
  cameras::StereoFrame photograph(std::int64_t number, double time_s, std::uint64_t noise_seed) const;
  /// Share of the face's skin that both cameras see, 0..1.
  double faceVisibleFraction() const;

  const RigidTransform<Camera, Room>& camera_T_room() const;
  const RoomCoil& coil() const;
  /// The second coil; nothing: none was added.
  const std::optional<RoomCoil>& secondCoil() const;
  const cameras::StereoRig& rig() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::room
