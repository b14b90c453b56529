#pragma once
// CoarseSearch: where the face has gone, from its looks alone: eighth-size pictures of the reference face, as
// it was, leaning, nearer and farther, found in both images by NCC. Needs no face detector (a covered or cut
// face has none to offer, and a cascade takes tens of milliseconds), and one picture a frame keeps each frame
// short.

#include <array>
#include <optional>
#include <vector>

#include "facenav/stereo/stereo_rig.h"
#include "image_pyramid.h"
#include "patch_model.h"

namespace facenav::tracking {

class CoarseSearch {
 public:
  CoarseSearch() = default;
  CoarseSearch(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& key, const PatchModel& model);

  /// The head's motion since the reference, roughly; nothing where either image holds nothing like the face.
  /// `attempt` counts up from 0 while the face is lost: even ones look for it as it was, the others for it
  /// changed.
  std::optional<Eigen::Isometry3d> find(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& now,
                                        int attempt) const;

 private:
  struct Picture {
    double roll_rad = 0.0, scale = 1.0;
    std::array<cv::Mat1f, 2> face;
    std::array<Eigen::Vector2d, 2> centre_px;  // of the model's centre in the picture
  };
  Picture turned(const Picture& upright, double roll_rad, double scale) const;

  std::vector<Picture> pictures_;  // the first: as it was
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace facenav::tracking
