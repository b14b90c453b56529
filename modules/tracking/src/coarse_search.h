#pragma once
// CoarseSearch: where the face has gone, from its looks alone: eighth-size pictures of the reference face, as
// it was, leaning, turned, nearer and farther, and of each key frame, found in both images by NCC. Needs no
// face detector (a covered or cut face has none to offer, and a cascade takes tens of milliseconds), and a
// few pictures a frame keep each frame short.

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

  /// Where the head may be, roughly, as motions since the reference: from the reference's picture, and from
  /// the next two of the others. `attempt` counts up from 0 while the face is lost. Empty where nothing in
  /// both images looks like the face.
  std::vector<Eigen::Isometry3d> find(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& now,
                                      int attempt) const;
  /// The face as it is seen at `motion` (a key frame), to be looked for, too.
  void add(const stereo::StereoRig& rig, const std::array<cv::Mat, 2>& grey, const PatchModel& model,
           const Eigen::Isometry3d& motion);

 private:
  struct Picture {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // of the head, that it shows
    std::array<cv::Mat1f, 2> face;
    std::array<Eigen::Vector2d, 2> centre_px;  // of the model's centre in the picture
  };
  /// The picture with every pixel moved by `now_from_then` about the face's middle.
  Picture changed(const Picture& picture, const Eigen::Matrix2d& now_from_then,
                  const Eigen::Matrix3d& turn) const;
  std::optional<Eigen::Isometry3d> locate(const stereo::StereoRig& rig,
                                          const std::array<cv::Mat1f, 2>& images,
                                          const Picture& picture) const;

  std::vector<Picture> pictures_;  // the first: as it was
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace facenav::tracking
