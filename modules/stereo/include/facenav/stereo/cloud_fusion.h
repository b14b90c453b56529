#pragma once
// CloudFusion: several clouds of one rigid face, each carried back to where the face was at first, merged
// over the left pixels of the first frame. What one frame gets wrong (noise, a glint, a lash) differs from
// frame to frame and averages out; what the frames share (the calibration, the window's smoothing) does not,
// and stays in the stated deviation.

#include <Eigen/Geometry>
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
  /// `shared_px`: of the clouds' deviations, what does not differ from frame to frame, as an error of the
  /// disparity (kPlainSkinError_px for plain skin).
  CloudFusion(const cameras::StereoRig& rig, double shared_px);

  /// `first_T_now`: carries Camera coordinates of this cloud back to the first frame; identity for the first
  /// itself.
  void add(const FaceCloud& cloud, const Eigen::Isometry3d& first_T_now);

  /// Each pixel's distance: the mean of those near the median. Its deviation: from their spread, and never
  /// below what all frames share. Seen once: as it was measured.
  FusedCloud fused() const;

 private:
  struct Sighting {
    float distance_mm, sigma_mm;  // along the pixel's ray
    float off_px;                 // from the pixel's centre
  };
  struct Cell {
    std::vector<Sighting> sightings;
    int last_cloud = -1;
    Eigen::Vector3f normals = Eigen::Vector3f::Zero();  // sum
  };
  void see(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal, float sigma_mm);

  cameras::StereoRig rig_;
  double shared_px_;
  std::vector<Cell> cells_;  // a pixel of the left image each
  int clouds_ = 0;
};

}  // namespace facenav::stereo
