#include "world_view.h"

#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"
#include "facenav/room/world_room.h"

namespace facenav::room {
namespace {

constexpr double kMargin_px = 6.0;
constexpr double kLargest = 1.1;  // of the drawn sizes of a head

bool isInside(const cameras::CameraModel& camera, const cameras::StereoRig& rig,
              const Eigen::Vector3d& p_mm) {
  if (p_mm.z() < 50.0 || p_mm.head<2>().norm() > 1.2 * p_mm.z()) return false;
  const Eigen::Vector2d px = cameras::project(camera, p_mm);
  return px.x() > kMargin_px && px.y() > kMargin_px && px.x() < rig.width_px - 1 - kMargin_px &&
         px.y() < rig.height_px - 1 - kMargin_px;
}

}  // namespace

RigidTransform<Room, Mri> facePose(const World& world, const WorldMoment& moment,
                                   const Point<Mri>& face_middle) {
  constexpr double kPivot_mm = 90.0;  // the head turns about a point so far behind the face
  Eigen::Matrix3d looking;            // at the cameras: anterior towards them, superior up
  looking << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  const Eigen::Vector3d face_mm(world.cameras.face_at_mm.x(), world.cameras.face_at_mm.y(),
                                world.cameras.distance_mm);
  // Straight: towards the rig's middle.
  const Eigen::Matrix3d straight = rotationBetween(Eigen::Vector3d(0, 0, -1), -face_mm).toRotationMatrix();
  const Eigen::Matrix3d seat = expRotation(world.seat_turn_deg * kRadPerDeg) * straight * looking;
  const Eigen::Matrix3d turned = expRotation(moment.turn_deg * kRadPerDeg) * seat;
  const Eigen::Vector3d behind(0, -kPivot_mm, 0);
  const Eigen::Vector3d pivot_mm = face_mm + seat * behind + moment.shift_mm;
  return {Eigen::Quaterniond(turned), pivot_mm - turned * (face_middle.mm + behind)};
}

bool isFaceInView(const World& world, const WorldMoment& moment) {
  const auto rig = trueRig(world);
  const auto camera_T_mri =
      cameraFromRoom(rig, world.cameras.rig.roll_deg) * facePose(world, moment, Point<Mri>(0, 0, 0));
  for (const double x : {-72.0, 72.0})
    for (const double z : {-85.0, 95.0}) {
      const Eigen::Vector3d p_mm = (camera_T_mri * Point<Mri>(kLargest * x, -20.0, kLargest * z)).mm;
      if (!isInside(rig.left, rig, p_mm)) return false;
      if (!isInside(rig.right, rig, rig.right_T_left.isometry() * p_mm)) return false;
    }
  return true;
}

}  // namespace facenav::room
