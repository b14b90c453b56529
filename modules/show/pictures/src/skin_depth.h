#pragma once
// SkinDepth: depth of the nearest skin at each pixel of one view, from a mesh. It determines which parts of
// the head a camera sees or a projector lights. Private to pictures.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::pictures {

class SkinDepth {
 public:
  /// Computes the map. `view_T_mri`: Mri in the lens's frame. One entry of the map is `step` pixels wide.
  SkinDepth(const surface::TriangleMesh& mesh, const Eigen::Isometry3d& view_T_mri,
            const cameras::CameraModel& lens, const cv::Size& size_px, int step);

  /// Vertex `i` in the lens's frame (mm) and its pixel (NaN: behind the lens or far outside the picture).
  const Eigen::Vector3d& point_mm(std::size_t i) const { return points_mm_[i]; }
  const Eigen::Vector2d& pixel(std::size_t i) const { return pixels_[i]; }
  /// True unless other skin is in front of the point by more than `slack_mm`; true outside the picture.
  bool isOpen(const Eigen::Vector2d& pixel, double depth_mm, double slack_mm) const;

 private:
  void draw(const Eigen::Vector3i& triangle);

  int step_;
  std::vector<Eigen::Vector3d> points_mm_;
  std::vector<Eigen::Vector2d> pixels_;
  cv::Mat inverse_depth_;  // 32-bit float, 1/mm; 0: no skin
};

}  // namespace facenav::pictures
