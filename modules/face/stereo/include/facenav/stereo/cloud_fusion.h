#pragma once
// CloudFusion: merges several clouds of one rigid face. Each is moved back to the face's first pose and added
// over the left pixels of the first frame. Errors of one frame (noise, a glint, a lash) average out. Errors
// that all frames share (calibration, the window's smoothing) do not, and remain in the predicted deviation.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::stereo {

struct FusedCloud {
  FaceCloud face;           // one point per pixel of the first frame's left image, row by row
  std::vector<int> frames;  // number of frames that measured each point
};

class CloudFusion {
 public:
  /// `shared_px`: the part of the clouds' deviation that all frames share, as an error of the disparity
  /// (kPlainSkinError_px for plain skin).
  CloudFusion(const cameras::StereoRig& rig, double shared_px);

  /// `first_T_now`: moves this cloud's Camera coordinates back to the first frame; identity for the first
  /// frame.
  void add(const FaceCloud& cloud, const Eigen::Isometry3d& first_T_now);

  /// Each pixel's distance is the mean of the values near the median. Its deviation follows from their
  /// spread, and is at least the error that all frames share. A pixel measured once keeps its measurement.
  FusedCloud fused() const;

 private:
  struct Observation {
    float distance_mm, sigma_mm;  // distance along the pixel's ray
    float off_px;                 // offset of the measured point from the pixel's centre
  };
  struct Cell {
    std::vector<Observation> observations;
    std::optional<int> last_cloud;
    Eigen::Vector3f normals = Eigen::Vector3f::Zero();  // sum of the normals
  };
  void see(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal, float sigma_mm);

  cameras::StereoRig rig_;
  double shared_px_;
  std::vector<Cell> cells_;  // one cell per pixel of the left image
  int clouds_ = 0;
};

}  // namespace facenav::stereo
