#include "coarse_search.h"

#include <opencv2/imgproc.hpp>

#include "patch_placement.h"

namespace facenav::tracking {
namespace {

constexpr int kLevel = 3;
constexpr double kShrink = 1 << kLevel;
constexpr double kLeastNcc = 0.45;
constexpr double kDegree = M_PI / 180;
constexpr double kRolls_rad[] = {18 * kDegree, -18 * kDegree, 36 * kDegree, -36 * kDegree};
constexpr double kYaw_rad = 22 * kDegree, kNod_rad = 14 * kDegree;
constexpr double kScales[] = {0.82, 1.22};
constexpr std::size_t kAtOnce = 2;  // pictures a frame beside the reference's

cv::Rect shrunk(const cv::Rect& box, cv::Size size) {
  const cv::Rect part(cv::Point(int(box.x / kShrink), int(box.y / kShrink)),
                      cv::Point(int(box.br().x / kShrink) + 1, int(box.br().y / kShrink) + 1));
  return part & cv::Rect({}, size);
}

Eigen::Matrix3d turnAbout(const Eigen::Vector3d& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

}  // namespace

CoarseSearch::CoarseSearch(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& key,
                           const PatchModel& model)
    : centre_mm_(model.centre_mm) {
  Picture upright;
  const auto boxes = boxesAt(rig, model, Eigen::Isometry3d::Identity(), 0);
  const Eigen::Vector2d centre_px[2] = {stereo::project(rig.left, centre_mm_),
                                        stereo::project(rig.right, rig.right_T_left.isometry() * centre_mm_)};
  for (int c = 0; c < 2; ++c) {
    const cv::Mat1f image = greyOf(key[c].level[kLevel]);
    const cv::Rect box = shrunk(boxes[c], image.size());
    upright.face[c] = image(box).clone();
    upright.centre_px[c] = centre_px[c] / kShrink - Eigen::Vector2d(box.x, box.y);
  }
  pictures_.push_back(upright);
  const auto leaning = [&](double roll_rad) {
    Eigen::Matrix2d turn;
    turn << std::cos(roll_rad), -std::sin(roll_rad), std::sin(roll_rad), std::cos(roll_rad);
    pictures_.push_back(changed(upright, turn, turnAbout(Eigen::Vector3d::UnitZ(), roll_rad)));
  };
  const auto foreshortened = [&](int axis, double angle_rad) {
    Eigen::Matrix2d squeeze = Eigen::Matrix2d::Identity();
    squeeze(1 - axis, 1 - axis) = std::cos(angle_rad);
    pictures_.push_back(changed(upright, squeeze, turnAbout(Eigen::Vector3d::Unit(axis), angle_rad)));
  };
  for (double sign : {1.0, -1.0}) foreshortened(1, sign * kYaw_rad);
  for (double roll_rad : kRolls_rad) leaning(roll_rad);
  for (double sign : {1.0, -1.0}) foreshortened(0, sign * kNod_rad);
  for (double scale : kScales)
    pictures_.push_back(changed(upright, scale * Eigen::Matrix2d::Identity(), Eigen::Matrix3d::Identity()));
}

CoarseSearch::Picture CoarseSearch::changed(const Picture& upright, const Eigen::Matrix2d& now_from_then,
                                            const Eigen::Matrix3d& turn) const {
  Picture picture;
  picture.turn = turn;
  const double scale = std::sqrt(std::abs(now_from_then.determinant()));
  const double lean = std::abs(now_from_then(1, 0)) / scale;
  for (int c = 0; c < 2; ++c) {
    const cv::Mat1f& face = upright.face[c];
    if (face.empty()) continue;
    // The middle part only when it leans: the corners would come from outside the picture.
    const double wide = std::hypot(now_from_then(0, 0), now_from_then(1, 0)),
                 high = std::hypot(now_from_then(0, 1), now_from_then(1, 1));
    const cv::Size size(int(wide * (face.cols - lean * 0.35 * face.rows)),
                        int(high * (face.rows - lean * 0.35 * face.cols)));
    if (size.width < 4 || size.height < 4) continue;
    const Eigen::Vector2d from(0.5 * (face.cols - 1), 0.5 * (face.rows - 1)),
        to(0.5 * (size.width - 1), 0.5 * (size.height - 1));
    const Eigen::Matrix2d& m = now_from_then;
    const Eigen::Vector2d shift = to - m * from;
    const cv::Matx23d warp(m(0, 0), m(0, 1), shift.x(), m(1, 0), m(1, 1), shift.y());
    cv::warpAffine(face, picture.face[c], warp, size, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    picture.centre_px[c] = m * upright.centre_px[c] + shift;
  }
  return picture;
}

void CoarseSearch::add(const stereo::StereoRig& rig, const std::array<cv::Mat, 2>& grey,
                       const PatchModel& model, const Eigen::Isometry3d& motion) {
  Picture picture;
  picture.turn = motion.linear();
  const auto boxes = boxesAt(rig, model, motion, 0);
  const Eigen::Vector3d centre_mm = motion * centre_mm_;
  const Eigen::Vector2d centre_px[2] = {stereo::project(rig.left, centre_mm),
                                        stereo::project(rig.right, rig.right_T_left.isometry() * centre_mm)};
  for (int c = 0; c < 2; ++c) {
    cv::Mat small;
    cv::resize(grey[c], small, {grey[c].cols / int(kShrink), grey[c].rows / int(kShrink)}, 0, 0,
               cv::INTER_AREA);
    const cv::Rect box = shrunk(boxes[c], small.size());
    if (box.area() == 0) return;
    small(box).convertTo(picture.face[c], CV_32F);
    // Pixel x of an area average has its centre half of the area beyond 8 x.
    picture.centre_px[c] = (centre_px[c] - Eigen::Vector2d::Constant(0.5 * (kShrink - 1))) / kShrink -
                           Eigen::Vector2d(box.x, box.y);
  }
  pictures_.insert(pictures_.begin() + 1, std::move(picture));
}

std::optional<Eigen::Isometry3d> CoarseSearch::locate(const stereo::StereoRig& rig,
                                                      const std::array<cv::Mat1f, 2>& images,
                                                      const Picture& picture) const {
  std::array<Eigen::Vector2d, 2> px;
  for (int c = 0; c < 2; ++c) {
    const cv::Mat1f &image = images[c], &face = picture.face[c];
    if (face.rows < 6 || face.cols < 6 || face.rows > image.rows || face.cols > image.cols)
      return std::nullopt;
    cv::Mat1f scores;
    cv::matchTemplate(image, face, scores, cv::TM_CCOEFF_NORMED);
    double best = 0;
    cv::Point at;
    cv::minMaxLoc(scores, nullptr, &best, nullptr, &at);
    if (!(best > kLeastNcc)) return std::nullopt;
    px[c] = kShrink * (picture.centre_px[c] + Eigen::Vector2d(at.x, at.y));
  }
  const Eigen::Vector3d now_mm = stereo::triangulate(rig, px[0], px[1]).mm;
  if (!(now_mm.z() > 0.4 * centre_mm_.z() && now_mm.z() < 2.5 * centre_mm_.z())) return std::nullopt;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = picture.turn;
  motion.translation() = now_mm - picture.turn * centre_mm_;
  return motion;
}

std::vector<Eigen::Isometry3d> CoarseSearch::find(const stereo::StereoRig& rig,
                                                  const std::array<ImagePyramid, 2>& now, int attempt) const {
  const std::array<cv::Mat1f, 2> images = {greyOf(now[0].level[kLevel]), greyOf(now[1].level[kLevel])};
  std::vector<Eigen::Isometry3d> found;
  if (const auto there = locate(rig, images, pictures_.front())) found.push_back(*there);
  const std::size_t others = pictures_.size() - 1;
  for (std::size_t k = 0; k < std::min(kAtOnce, others); ++k)
    if (const auto there = locate(rig, images, pictures_[1 + (kAtOnce * std::size_t(attempt) + k) % others]))
      found.push_back(*there);
  return found;
}

}  // namespace facenav::tracking
