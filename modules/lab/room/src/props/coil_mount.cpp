#include "coil_mount.h"

#include <array>
#include <cmath>

#include "facenav/geometry/rotation.h"
#include "marker_plate.h"
#include "optics/camera_rays.h"
#include "optics/ray_scene.h"

namespace facenav::room {
namespace {

const Eigen::Vector3d kUsual_mm(0.0, 0.0, -85.0);  // Coil

/// Candidate centres of the plate, Coil frame.
std::vector<Eigen::Vector3d> places() {
  constexpr int kAround = 12;
  std::vector<Eigen::Vector3d> places{kUsual_mm};
  for (const double behind_mm : {60.0, 85.0, 110.0, 140.0})
    for (const double aside_mm : {0.0, 40.0, 70.0, 100.0, 130.0})
      for (int i = 0; i < (aside_mm > 0 ? kAround : 1); ++i) {
        const double angle = 2.0 * M_PI * i / kAround;
        places.emplace_back(aside_mm * std::cos(angle), aside_mm * std::sin(angle), -behind_mm);
      }
  return places;
}

RoomCoil coilWithPlateAt(const Eigen::Vector3d& place_mm, const Eigen::Matrix3d& coil_R_marker) {
  Eigen::Isometry3d coil_T_marker = Eigen::Isometry3d::Identity();
  coil_T_marker.linear() = coil_R_marker;
  coil_T_marker.translation() = place_mm;
  RoomCoil coil;
  coil.marker_T_coil = RigidTransform<Marker, Coil>::fromIsometry(coil_T_marker.inverse());
  return coil;
}

/// Visibility by ray casting, with head and coil. World = Camera.
class Sightlines {
 public:
  Sightlines(const VirtualPatient& patient, const CoilView& view,
             const RigidTransform<Camera, Coil>& camera_T_coil)
      : camera_T_coil_(camera_T_coil.isometry()),
        face_mm_((view.camera_T_room * view.room_T_mri * patient.face_middle).mm),
        cameras_{
            CameraRays(view.rig.left, view.rig.width_px, view.rig.height_px, Eigen::Isometry3d::Identity()),
            CameraRays(view.rig.right, view.rig.width_px, view.rig.height_px,
                       view.rig.right_T_left.isometry())} {
    scene_.setPose(scene_.add(patient.visible), (view.camera_T_room * view.room_T_mri).isometry());
    scene_.setPose(scene_.add(coilBodyMesh()), camera_T_coil_);
    scene_.commit();
  }

  /// Share of the plate that both cameras see, over small shifts of the whole head and coil, minus the part
  /// of the face that the plate hides (as a share of the face's diameter). The white border counts as well: a
  /// detector finds no square whose border is covered in one place.
  double shown(const RoomCoil& coil) const {
    constexpr double kShift_mm = 20.0;
    constexpr int kSteps = 3;  // a point each 14 mm on a marker of 60 mm
    const Eigen::Isometry3d world_T_marker = camera_T_coil_ * coil.marker_T_coil.inverse().isometry();
    const double step_mm = 0.5 * kPlatePerMarker * coil.marker_size_mm / kSteps;
    int seen = 0, all = 0;
    for (const double dx : {-kShift_mm, 0.0, kShift_mm})
      for (const double dy : {-kShift_mm, 0.0, kShift_mm})
        for (int x = -kSteps; x <= kSteps; ++x)
          for (int y = -kSteps; y <= kSteps; ++y)
            for (const CameraRays& camera : cameras_) {
              const Eigen::Vector3d shift(dx, dy, 0);
              const Eigen::Vector3d p = world_T_marker * Eigen::Vector3d(x * step_mm, y * step_mm, -0.5);
              ++all;
              seen += camera.shows(p + shift) && !scene_.isBlocked(p, camera.origin_mm() - shift);
            }
    return double(seen) / all - faceTaken(world_T_marker.translation(), coil.marker_size_mm);
  }

 private:
  double faceTaken(const Eigen::Vector3d& plate_mm, double marker_mm) const {
    constexpr double kFaceRadius_mm = 75.0;
    const double reach_mm = kFaceRadius_mm + 0.5 * kPlatePerMarker * marker_mm;
    double taken = 0.0;
    for (const CameraRays& camera : cameras_) {
      const Eigen::Vector3d to_face = (face_mm_ - camera.origin_mm()).normalized();
      const Eigen::Vector3d to_plate = (plate_mm - camera.origin_mm()).normalized();
      const double apart_mm = to_face.cross(to_plate).norm() * (face_mm_ - camera.origin_mm()).norm();
      taken = std::max(taken, (reach_mm - apart_mm) / reach_mm);
    }
    return taken;
  }

  Eigen::Isometry3d camera_T_coil_;
  Eigen::Vector3d face_mm_;
  std::array<CameraRays, 2> cameras_;
  RayScene scene_;
};

}  // namespace

RoomCoil mountedCoil(const RigidTransform<Mri, frames::Target>& target, const VirtualPatient& patient,
                     const CoilView& view) {
  constexpr double kTilt_rad = 0.17, kPerMm = 0.0005;
  const RigidTransform<Room, frames::Target> room_T_coil = view.room_T_mri * target;
  // Tilted slightly against the view: the tilt of a marker seen exactly face-on is least certain.
  const Eigen::Matrix3d coil_R_marker =
      room_T_coil.rotation().transpose() * expRotation(Eigen::Vector3d(kTilt_rad, -kTilt_rad, 0.0));
  const Sightlines sightlines(
      patient, view,
      RigidTransform<Camera, Coil>::fromIsometry((view.camera_T_room * room_T_coil).isometry()));
  double best = -1e9;
  RoomCoil mounted;
  for (const Eigen::Vector3d& place : places()) {
    const RoomCoil coil = coilWithPlateAt(place, coil_R_marker);
    const double value = sightlines.shown(coil) - kPerMm * (place - kUsual_mm).norm();
    if (value > best) best = value, mounted = coil;
  }
  return mounted;
}

}  // namespace facenav::room
