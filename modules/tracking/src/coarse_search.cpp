#include "coarse_search.h"

#include <opencv2/imgproc.hpp>

namespace facenav::tracking {
namespace {

constexpr int kLevel = 3;
constexpr double kLeastNcc = 0.45;
constexpr double kDegree = M_PI / 180;
constexpr double kRolls_rad[] = {18 * kDegree, -18 * kDegree, 36 * kDegree, -36 * kDegree};
constexpr double kScales[] = {0.82, 1.22};

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
  Picture upright;
  const Eigen::Vector2d centre_px[2] = {stereo::project(rig.left, centre_mm_),
                                        stereo::project(rig.right, rig.right_T_left.isometry() * centre_mm_)};
  for (int c = 0; c < 2; ++c) {
    const cv::Mat1f image = greyOf(key[c].level[kLevel]);
    const cv::Rect box = boxOf(model, c, image.size());
    upright.face[c] = image(box).clone();
    upright.centre_px[c] = centre_px[c] / (1 << kLevel) - Eigen::Vector2d(box.x, box.y);
  }
  pictures_.push_back(upright);
  for (double roll_rad : kRolls_rad) pictures_.push_back(turned(upright, roll_rad, 1.0));
  for (double scale : kScales) pictures_.push_back(turned(upright, 0.0, scale));
}

CoarseSearch::Picture CoarseSearch::turned(const Picture& upright, double roll_rad, double scale) const {
  Picture picture;
  picture.roll_rad = roll_rad, picture.scale = scale;
  for (int c = 0; c < 2; ++c) {
    const cv::Mat1f& face = upright.face[c];
    if (face.empty()) continue;
    // The middle part only when it leans: the corners would come from outside the picture.
    const double lean = std::abs(std::sin(roll_rad));
    const cv::Size size(int(scale * (face.cols - lean * 0.35 * face.rows)),
                        int(scale * (face.rows - lean * 0.35 * face.cols)));
    if (size.width < 4 || size.height < 4) continue;
    const Eigen::Vector2d from(0.5 * (face.cols - 1), 0.5 * (face.rows - 1)),
        to(0.5 * (size.width - 1), 0.5 * (size.height - 1));
    Eigen::Matrix2d turn;
    turn << std::cos(roll_rad), -std::sin(roll_rad), std::sin(roll_rad), std::cos(roll_rad);
    turn *= scale;
    const Eigen::Vector2d shift = to - turn * from;
    const cv::Matx23d warp(turn(0, 0), turn(0, 1), shift.x(), turn(1, 0), turn(1, 1), shift.y());
    cv::warpAffine(face, picture.face[c], warp, size, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    picture.centre_px[c] = turn * upright.centre_px[c] + shift;
  }
  return picture;
}

std::optional<Eigen::Isometry3d> CoarseSearch::find(const stereo::StereoRig& rig,
                                                    const std::array<ImagePyramid, 2>& now,
                                                    int attempt) const {
  const std::size_t others = pictures_.size() - 1;
  const Picture& picture = pictures_[attempt % 2 == 0 ? 0 : 1 + std::size_t(attempt / 2) % others];
  std::array<Eigen::Vector2d, 2> px;
  for (int c = 0; c < 2; ++c) {
    const cv::Mat1f image = greyOf(now[c].level[kLevel]);
    const cv::Mat1f& face = picture.face[c];
    if (face.rows < 6 || face.cols < 6 || face.rows > image.rows || face.cols > image.cols)
      return std::nullopt;
    cv::Mat1f scores;
    cv::matchTemplate(image, face, scores, cv::TM_CCOEFF_NORMED);
    double best = 0;
    cv::Point at;
    cv::minMaxLoc(scores, nullptr, &best, nullptr, &at);
    if (!(best > kLeastNcc)) return std::nullopt;
    px[c] = double(1 << kLevel) * (picture.centre_px[c] + Eigen::Vector2d(at.x, at.y));
  }
  const Eigen::Vector3d now_mm = stereo::triangulate(rig, px[0], px[1]).mm;
  if (!(now_mm.z() > 0.4 * centre_mm_.z() && now_mm.z() < 2.5 * centre_mm_.z())) return std::nullopt;
  const Eigen::AngleAxisd lean(picture.roll_rad, Eigen::Vector3d::UnitZ());
  return Eigen::Isometry3d(Eigen::Translation3d(now_mm) * lean * Eigen::Translation3d(-centre_mm_));
}

}  // namespace facenav::tracking
