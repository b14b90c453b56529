#include "coarse_search.h"

#include <opencv2/imgproc.hpp>

namespace facenav::tracking {
namespace {

constexpr int kLevel = 3;
constexpr double kLeastNcc = 0.45;

cv::Rect boxOf(const PatchModel& model, int camera, cv::Size size) {
  std::vector<cv::Point2f> points;
  for (const auto& patch : model.level[0].patches)
    if (patch.view[camera].is_usable)
      points.emplace_back(float(patch.view[camera].px.x()) / (1 << kLevel),
                          float(patch.view[camera].px.y()) / (1 << kLevel));
  return points.size() < 3 ? cv::Rect() : cv::boundingRect(points) & cv::Rect({}, size);
}

}  // namespace

CoarseSearch::CoarseSearch(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& key,
                           const PatchModel& model)
    : centre_mm_(model.centre_mm) {
  for (int c = 0; c < 2; ++c) {
    const auto& image = key[c].level[kLevel];
    const cv::Rect box = boxOf(model, c, image.size());
    place_[c] = box.tl();
    face_[c] = image(box).clone();
  }
  centre_px_ = {stereo::project(rig.left, centre_mm_),
                stereo::project(rig.right, rig.right_T_left.isometry() * centre_mm_)};
}

std::optional<Eigen::Isometry3d> CoarseSearch::find(const stereo::StereoRig& rig,
                                                    const std::array<ImagePyramid, 2>& now) const {
  std::array<Eigen::Vector2d, 2> px;
  for (int c = 0; c < 2; ++c) {
    const auto& image = now[c].level[kLevel];
    if (face_[c].empty() || face_[c].rows < 6 || face_[c].cols < 6 || face_[c].rows > image.rows ||
        face_[c].cols > image.cols)
      return std::nullopt;
    cv::Mat1f scores;
    cv::matchTemplate(image, face_[c], scores, cv::TM_CCOEFF_NORMED);
    double best = 0;
    cv::Point at;
    cv::minMaxLoc(scores, nullptr, &best, nullptr, &at);
    if (!(best > kLeastNcc)) return std::nullopt;
    px[c] = centre_px_[c] + double(1 << kLevel) * Eigen::Vector2d(at.x - place_[c].x, at.y - place_[c].y);
  }
  const Eigen::Vector3d now_mm = stereo::triangulate(rig, px[0], px[1]).mm;
  if (!(now_mm.z() > 0.4 * centre_mm_.z() && now_mm.z() < 2.5 * centre_mm_.z())) return std::nullopt;
  return Eigen::Isometry3d(Eigen::Translation3d(now_mm - centre_mm_));
}

}  // namespace facenav::tracking
