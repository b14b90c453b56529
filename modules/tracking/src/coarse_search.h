#pragma once
// CoarseSearch: where the face has gone, from its looks alone: an eighth-size picture of the reference face,
// found in both images by NCC. Needs no face detector (a covered or cut face has none to offer), knows shifts
// only.

#include <array>
#include <optional>

#include "facenav/stereo/stereo_rig.h"
#include "image_pyramid.h"
#include "patch_model.h"

namespace facenav::tracking {

class CoarseSearch {
 public:
  CoarseSearch() = default;
  CoarseSearch(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& key, const PatchModel& model);

  /// The shift of the head since the reference; nothing where either image holds nothing like the face.
  std::optional<Eigen::Isometry3d> find(const stereo::StereoRig& rig,
                                        const std::array<ImagePyramid, 2>& now) const;

 private:
  std::array<cv::Mat1f, 2> face_;
  std::array<cv::Point, 2> place_;            // top left of the face in the key frame, pixels of the level
  std::array<Eigen::Vector2d, 2> centre_px_;  // of the model's centre in the key frame, full resolution
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace facenav::tracking
