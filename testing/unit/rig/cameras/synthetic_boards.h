#pragma once
// Corners of boards at random poses before a rig: input of the calibration's tests.

#include <opencv2/calib3d.hpp>
#include <random>

#include "facenav/cameras/calibrate.h"
#include "support/stereo_rigs.h"

namespace facenav::cameras {

inline const Board kBoard{9, 6, 20.0};

// Views of boards at random poses before the rig, with Gaussian noise.
inline std::vector<BoardView> syntheticViews(const StereoRig& rig, int count, double noise_px, unsigned seed,
                                             double most_turned_rad = 0.6) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, noise_px);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<BoardView> views;
  while (int(views.size()) < count) {
    const Eigen::Matrix3d r =
        expRotation({most_turned_rad * unit(random), most_turned_rad * unit(random), 0.4 * unit(random)});
    const Eigen::Vector3d t(110 * unit(random), 80 * unit(random), 560 + 150 * unit(random));
    BoardView view{"view " + std::to_string(views.size()), {}, {}, {}, {}};
    bool is_inside = true;
    for (const cv::Point3f& p : boardPoints(kBoard)) {
      const Eigen::Vector3d q = r * Eigen::Vector3d(p.x - 80, p.y - 50, 0) + t;
      for (const auto& [camera, point, corners] :
           {std::tuple(&rig.left, q, &view.left),
            std::tuple(&rig.right, Eigen::Vector3d(rig.right_T_left.isometry() * q), &view.right)}) {
        const Eigen::Vector2d pixel = project(*camera, point);
        is_inside &=
            pixel.x() > 5 && pixel.y() > 5 && pixel.x() < rig.width_px - 5 && pixel.y() < rig.height_px - 5;
        corners->emplace_back(float(pixel.x() + noise(random)), float(pixel.y() + noise(random)));
      }
    }
    if (is_inside) views.push_back(view);
  }
  return views;
}

// Views whose boards moved by `moved_mm` (and turned a little) before the right camera exposed.
inline std::vector<BoardView> laggingViews(const StereoRig& rig, int count, const std::vector<int>& lagging,
                                           double moved_mm, unsigned seed) {
  auto views = syntheticViews(rig, count, 0.1, seed);
  std::mt19937 random(seed + 1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const int i : lagging) {
    cv::Vec3d turn, shift;
    cv::solvePnP(boardPoints(kBoard), views[std::size_t(i)].right, rig.right.k, rig.right.distortion, turn,
                 shift);
    const double angle = M_PI * unit(random);
    shift += moved_mm * cv::Vec3d(std::cos(angle), std::sin(angle), 0);
    cv::projectPoints(boardPoints(kBoard), turn + cv::Vec3d(0.003, 0, 0), shift, rig.right.k,
                      rig.right.distortion, views[std::size_t(i)].right);
  }
  return views;
}

}  // namespace facenav::cameras
