#pragma once
// Photographs of a printed plate at a known pose in the room, for tests with OpenCV's detectors.

#include <array>

#include "facenav/geometry/rotation.h"
#include "optics/film.h"
#include "optics/renderer.h"
#include "props/marker_plate.h"

namespace facenav::testing {

struct PlatePhotographer {
  cameras::StereoRig rig;
  room::RayScene scene;
  std::vector<std::shared_ptr<const room::Look>> looks;
  std::array<room::CameraRays, 2> rays;
  room::Lighting lighting;

  PlatePhotographer(const cameras::StereoRig& r, const surface::TriangleMesh& mesh,
                    std::shared_ptr<const room::Look> look)
      : rig(r),
        looks{std::move(look)},
        rays{room::CameraRays(r.left, r.width_px, r.height_px, Eigen::Isometry3d::Identity()),
             room::CameraRays(r.right, r.width_px, r.height_px, r.right_T_left.isometry())} {
    scene.add(mesh);
    lighting.lamps = {{Eigen::Vector3d(-500, -800, -300), 0.6, 1500.0}};
    lighting.ambient = 0.5;
  }

  std::array<cv::Mat, 2> photograph(const Eigen::Isometry3d& camera_T_plate, double noise_grey) {
    scene.setPose(0, camera_T_plate);
    scene.commit();
    std::array<cv::Mat, 2> images;
    for (std::size_t side = 0; side < 2; ++side) {
      const room::Renderer renderer(rays[side],
                                    cv::Mat(rig.height_px, rig.width_px, CV_32F, cv::Scalar(0.2)));
      images[side] = room::develop(renderer.render(scene, looks, lighting).radiance,
                                   {0.6, 1.2, 1.0, noise_grey}, side + 1);
    }
    return images;
  }

  /// Truth: image position of a point of the plate in one camera.
  Eigen::Vector2d project(std::size_t side, const Eigen::Isometry3d& camera_T_plate,
                          const Eigen::Vector3d& p_mm) const {
    const Eigen::Vector3d p = camera_T_plate * p_mm;
    return side == 0 ? cameras::project(rig.left, p)
                     : cameras::project(rig.right, rig.right_T_left.isometry() * p);
  }
};

inline Eigen::Isometry3d platePose(const Eigen::Vector3d& at_mm, const Eigen::Vector3d& turn_rad) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = expRotation(turn_rad);
  pose.translation() = at_mm;
  return pose;
}

}  // namespace facenav::testing
