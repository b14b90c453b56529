#pragma once
// AveragedPair: the first pair of a film with less noise. The frames are warped onto the first one by the
// face's motion and its measured surface, and averaged. The noise of a disparity is not symmetric where the
// texture is weak, so that an average of clouds keeps a part of it; an average of pictures does not.

#include <Eigen/Geometry>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/point.h"

namespace facenav::measured_face {

class AveragedPair {
 public:
  explicit AveragedPair(const cameras::StereoRig& rig) : rig_(rig) {}

  /// Keeps the frame (8-bit, of the rig's size). Later ones are left out if the face has turned far, since
  /// its shading then differs, or if there are enough.
  void add(const cameras::StereoFrame& frame, const Eigen::Isometry3d& now_T_first);
  std::size_t frames() const { return frames_.size(); }

  /// The average of the frames at the first one's pose. Pixels beside the surface are the first frame's.
  /// `surface`: the face in Camera at the first frame, about a point a pixel.
  cameras::StereoFrame averaged(const PointCloud<Camera>& surface) const;

 private:
  struct Kept {
    cameras::StereoFrame frame;
    Eigen::Isometry3d now_T_first;
  };
  cv::Mat averaged(const PointCloud<Camera>& surface, bool is_right) const;

  cameras::StereoRig rig_;
  std::vector<Kept> frames_;
};

}  // namespace facenav::measured_face
