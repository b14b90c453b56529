#pragma once
// CloudFusion: several clouds of one rigid face, each moved back to the face's first pose and merged over the
// left pixels of the first frame. Errors of one frame (noise, a glint, a lash) average out. Errors that all
// frames share (calibration, the window's smoothing) do not, and stay in the stated deviation.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::stereo {

struct FusedCloud {
  FaceCloud face;           // a point a pixel of the first frame's left image, row by row
  std::vector<int> frames;  // that saw each point
};

class CloudFusion {
 public:
  /// `shared_px`: the part of the clouds' deviation that all frames share, as an error of the disparity
  /// (kPlainSkinError_px for plain skin).
  CloudFusion(const cameras::StereoRig& rig, double shared_px);

  /// `first_T_now`: moves this cloud's Camera coordinates back to the first frame; identity for the first
  /// frame.
  void add(const FaceCloud& cloud, const Eigen::Isometry3d& first_T_now);

  /// Each pixel's distance: the mean of those near the median. Its deviation: from their spread, never below
  /// what all frames share. A pixel seen once keeps its measurement.
  FusedCloud fused() const;

 private:
  struct Observation {
    float distance_mm, sigma_mm;  // along the pixel's ray
    float off_px;                 // from the pixel's centre
  };
  struct Cell {
    std::vector<Observation> observations;
    std::optional<int> last_cloud;
    Eigen::Vector3f normals = Eigen::Vector3f::Zero();  // sum
  };
  void see(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal, float sigma_mm);

  cameras::StereoRig rig_;
  double shared_px_;
  std::vector<Cell> cells_;  // a pixel of the left image each
  int clouds_ = 0;
};

}  // namespace facenav::stereo
