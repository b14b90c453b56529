#include "facenav/measured_face/plain_skin.h"

#include <algorithm>

#include "facenav/anatomy/head_norms.h"
#include "facenav/cameras/reduced_pair.h"

namespace facenav::measured_face {
namespace {

constexpr double kBefore_mm = 180.0;  // distance of a hand or coil in front of the landmarks' centre
constexpr double kAround_mm = 150.0;
// Resolution beyond which plain skin shows little detail; larger images are reduced to it.
constexpr double kPlainSkin_px_per_mm = 1.0;
// Where the face's place is unknown, the whole picture is searched in all depths. Smaller pictures are used
// there: memory and time of that search grow with the third power of their size.
constexpr double kUnplaced_px_per_mm = 0.5, kUnknownDepth_mm = 600.0;

cv::Rect roiAround(const cameras::StereoRig& rig, const Eigen::Vector3d& centre_mm) {
  const Eigen::Vector2d px = cameras::project(rig.left, centre_mm);
  const double reach_px = kAround_mm * rig.left.k(0, 0) / centre_mm.z();
  return cv::Rect(cv::Point(int(px.x() - reach_px), int(px.y() - reach_px)),
                  cv::Point(int(px.x() + reach_px), int(px.y() + reach_px))) &
         cv::Rect(0, 0, rig.width_px, rig.height_px);
}

}  // namespace

int plainReduction(const cameras::StereoRig& rig, const FaceInSpace& face) {
  if (!face.centre) return cameras::reductionFor(rig, kUnknownDepth_mm, kUnplaced_px_per_mm);
  return cameras::reductionFor(rig, face.centre->mm.z(), kPlainSkin_px_per_mm);
}

void toWholePicture(stereo::FaceCloud& cloud, int times) {
  for (auto& px : cloud.left_px) px = cameras::inWholePicture(px, times);
}

stereo::FaceCloud measureNear(const cameras::StereoRig& rig, const cameras::StereoFrame& frame, bool has_dots,
                              const FaceInSpace& face, TaskMonitor& monitor) {
  stereo::FaceCloudOptions options = has_dots ? stereo::FaceCloudOptions() : stereo::plainFaceOptions();
  if (face.centre) {
    options.nearest_mm = std::max(100.0, face.centre->mm.z() - kBefore_mm);
    options.farthest_mm = face.centre->mm.z() + anatomy::kHeadDepth_mm;
    options.left_roi = roiAround(rig, face.centre->mm);
  }
  return cutFace(stereo::measureFace(rig, frame, options, monitor), face);
}

stereo::FaceCloud measurePlainSkin(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                   const FaceInSpace& face, TaskMonitor& monitor) {
  const int times = plainReduction(rig, face);
  auto cloud =
      measureNear(cameras::reduced(rig, times), cameras::reduced(frame, times), false, face, monitor);
  toWholePicture(cloud, times);
  return cloud;
}

}  // namespace facenav::measured_face
