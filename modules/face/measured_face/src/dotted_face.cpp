#include "facenav/measured_face/dotted_face.h"

#include <algorithm>

namespace facenav::measured_face {
namespace {

/// The face's box, enlarged to include forehead, chin and temples; empty if no face was found.
std::optional<cv::Rect> region(const FaceInSpace& face, const cameras::StereoRig& rig) {
  if (!face.left) return std::nullopt;
  const cv::Rect& box = face.left->face;
  const int grow_x = box.width / 2, grow_y = int(0.6 * box.height);
  const cv::Rect grown(box.x - grow_x, box.y - grow_y, box.width + 2 * grow_x, box.height + 2 * grow_y);
  const cv::Rect inside = grown & cv::Rect(0, 0, rig.width_px, rig.height_px);
  if (inside.area() <= 0) return std::nullopt;
  return inside;
}

stereo::FaceCloudOptions measuringOptions(const FaceInSpace& face, const cameras::StereoRig& rig,
                                          const std::string& matcher) {
  stereo::FaceCloudOptions options = stereo::dottedFaceOptions(matcher);
  options.left_roi = region(face, rig);
  if (face.centre) {
    options.nearest_mm = std::max(100.0, face.centre->mm.z() - 180.0);
    options.farthest_mm = face.centre->mm.z() + 220.0;
  }
  return options;
}

}  // namespace

stereo::FaceCloud measureDotted(const cameras::StereoRig& rig, const cameras::StereoFrame& dotted,
                                const FaceInSpace& face, const std::string& matcher, TaskMonitor& monitor) {
  return cutFace(stereo::measureFace(rig, dotted, measuringOptions(face, rig, matcher), monitor), face);
}

}  // namespace facenav::measured_face
