#include "skin_points.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace facenav::head_tracking {
namespace {

constexpr double kSmoothing_px = 0.8;   // before matching, against sensor noise and compression artefacts
constexpr double kLight_px = 3.0;       // in pixels of a level; slower changes are lighting, not skin
constexpr double kCells = 24.0;         // cells over the face's width; at most one point in each cell
constexpr double kWindowShare = 0.028;  // half window relative to the face's width: 8 mm of skin in all
constexpr int kLeastHalf_px = 5;        // half side of a window, at any level
constexpr double kLeastTexture_grey =
    0.6;  // texture limit along the weaker direction; its scale: see `least`
constexpr double kLeastCorrelation = 0.45;  // at the best place
constexpr double kPlaceError_px = 0.25;     // in pixels of a level: error from sampling and shape
constexpr double kIndependent_px2 = 12.0;   // area of correlated errors in compressed, smoothed images
constexpr int kMarginWindows = 5;           // half windows kept around the face in a key frame

const cameras::CameraModel& cameraOf(const cameras::StereoRig& rig, int c) {
  return c == 0 ? rig.left : rig.right;
}

Eigen::Isometry3d seenFrom(const cameras::StereoRig& rig, int c, const Eigen::Isometry3d& camera_T_head) {
  return c == 0 ? camera_T_head : rig.right_T_left.isometry() * camera_T_head;
}

// Two unit tangents of the skin.
Eigen::Matrix<double, 3, 2> tangentsOf(const Eigen::Vector3d& normal) {
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = normal.unitOrthogonal();
  tangents.col(1) = normal.cross(tangents.col(0));
  return tangents;
}

// Place of the best correlation with sub-pixel precision, and the curvature there.
struct Peak {
  Eigen::Vector2d at;
  Eigen::Matrix2d curvature;
  double value;
};

std::optional<Peak> peakOf(const cv::Mat1f& map) {
  double best = 0;
  cv::Point at;
  cv::minMaxLoc(map, nullptr, &best, nullptr, &at);
  if (at.x < 1 || at.y < 1 || at.x >= map.cols - 1 || at.y >= map.rows - 1) return std::nullopt;
  const auto v = [&](int dx, int dy) { return double(map(at.y + dy, at.x + dx)); };
  const Eigen::Vector2d slope(0.5 * (v(1, 0) - v(-1, 0)), 0.5 * (v(0, 1) - v(0, -1)));
  Eigen::Matrix2d curvature;
  curvature(0, 0) = 2 * v(0, 0) - v(1, 0) - v(-1, 0);
  curvature(1, 1) = 2 * v(0, 0) - v(0, 1) - v(0, -1);
  curvature(0, 1) = curvature(1, 0) = -0.25 * (v(1, 1) - v(1, -1) - v(-1, 1) + v(-1, -1));
  if (!(curvature.trace() > 1e-6) || !(curvature.determinant() > 1e-9)) return std::nullopt;
  Eigen::Vector2d step = curvature.inverse() * slope;
  if (!(step.cwiseAbs().maxCoeff() < 1.0)) step.setZero();
  return Peak{Eigen::Vector2d(at.x, at.y) + step, curvature, best};
}

bool facesCamera(const SkinPoint& point, const Eigen::Isometry3d& camera_T_head) {
  const Eigen::Vector3d p_mm = camera_T_head * point.mm;
  return p_mm.z() > 0 && -(camera_T_head.linear() * point.normal).dot(p_mm.normalized()) > kGrazing_cos;
}

// One camera with one pyramid level of its image.
struct Sight {
  const cameras::CameraModel* camera;
  Eigen::Isometry3d camera_T_head;
  const cv::Mat1f* picture;
};

// Warps the point's window from the image of `before` to its predicted appearance in `after`, and searches it
// there. `scale`: pixels of the level per full-resolution pixel. The caller fills the jacobian's rotation.
std::optional<SkinMatch> findPoint(const SkinPoint& point, const Sight& before, const Sight& after,
                                   double scale, int half, int reach) {
  Eigen::Matrix<double, 2, 3> d_before, d_after;
  const Eigen::Vector2d before_px = scale * cameras::project(*before.camera, before.camera_T_head * point.mm,
                                                             d_before),
                        after_px =
                            scale * cameras::project(*after.camera, after.camera_T_head * point.mm, d_after);
  const cv::Point place(int(std::lround(after_px.x())), int(std::lround(after_px.y())));
  const int outer = half + reach;
  const cv::Rect around(place.x - outer, place.y - outer, 2 * outer + 1, 2 * outer + 1);
  if ((around & cv::Rect({}, after.picture->size())) != around) return std::nullopt;
  const Eigen::Matrix<double, 3, 2> tangents = tangentsOf(point.normal);
  const Eigen::Matrix2d skin = d_after * after.camera_T_head.linear() * tangents;
  if (std::abs(skin.determinant()) < 1e-6) return std::nullopt;
  const Eigen::Matrix2d before_from_after =
      d_before * before.camera_T_head.linear() * tangents * skin.inverse();
  const Eigen::Vector2d middle(place.x, place.y);
  const Eigen::Vector2d corner =
      before_px + before_from_after * (middle - after_px - Eigen::Vector2d::Constant(double(half)));
  const cv::Matx23f warp(float(before_from_after(0, 0)), float(before_from_after(0, 1)), float(corner.x()),
                         float(before_from_after(1, 0)), float(before_from_after(1, 1)), float(corner.y()));
  cv::Mat1f window, map;
  cv::warpAffine(*before.picture, window, warp, {2 * half + 1, 2 * half + 1},
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  cv::matchTemplate((*after.picture)(around), window, map, cv::TM_CCOEFF_NORMED);
  const auto peak = peakOf(map);
  if (!peak || peak->value < kLeastCorrelation) return std::nullopt;
  SkinMatch match;
  match.correlation = peak->value;
  // The window is centred on what the pose predicts at `middle`, a whole pixel. The point itself lies beside
  // it.
  match.offset_px = (peak->at - Eigen::Vector2d::Constant(double(reach))) / scale;
  match.px = after_px / scale + match.offset_px;
  const double independent = double(window.total()) / kIndependent_px2;
  match.covariance = (std::max(0.0, 1 - peak->value * peak->value) / independent * peak->curvature.inverse() +
                      kPlaceError_px * kPlaceError_px * Eigen::Matrix2d::Identity()) /
                     (scale * scale);
  match.jacobian.rightCols<3>() = d_after * after.camera_T_head.linear();
  return match;
}

}  // namespace

Eigen::Matrix2d errorOf(const SkinMatch& match, double mobility_mm) {
  const Eigen::Matrix<double, 2, 3> d_p = match.jacobian.rightCols<3>();
  return match.covariance + mobility_mm * mobility_mm * d_p * d_p.transpose();
}

RecoveryPictures::RecoveryPictures(const cameras::StereoFrame& frame) {
  for (int c = 0; c < 2; ++c) {
    cv::Mat1f grey;
    (c == 0 ? frame.left : frame.right).convertTo(grey, CV_32F);
    cv::GaussianBlur(grey, level[0][c], {}, kSmoothing_px);
    for (int l = 1; l < kLevels; ++l) cv::pyrDown(level[l - 1][c], level[l][c]);
    for (int l = 0; l < kLevels; ++l) {
      cv::Mat1f light;
      cv::GaussianBlur(level[l][c], light, {}, kLight_px);
      level[l][c] -= light;
    }
  }
}

SkinPoints::SkinPoints(const cameras::StereoRig& rig, const cameras::StereoFrame& reference,
                       const FaceRegion& region, const FaceSurface& surface, const SkinMobility& mobility) {
  reference_.rig = rig;
  reference_.pictures = RecoveryPictures(reference);
  const cv::Rect box = region.box();
  if (box.width < 8 || box.height < 8) return;
  half_window_px_ = std::max(kLeastHalf_px, int(std::lround(kWindowShare * box.width)));
  cv::Mat1f texture;
  const int side = 2 * half_window_px_ + 1;
  cv::cornerMinEigenVal(reference_.pictures.level[0][0], texture, side, 3);
  const double cell = std::max(4.0, box.width / kCells);
  independent_share_ = 0.5 * std::min(1.0, std::pow(cell / side, 2));
  // Limit of OpenCV's eigenvalue, which is about 4 times the mean squared gradient along the weaker direction
  // for windows of 11 to 25 px. It corresponds to an rms gradient of kLeastTexture_grey / (4 side).
  const double least = std::pow(kLeastTexture_grey * 0.5 / side, 2);
  for (double y0 = box.y; y0 < box.br().y; y0 += cell)
    for (double x0 = box.x; x0 < box.br().x; x0 += cell) {
      double best = least;
      cv::Point at(-1, -1);
      for (int y = int(y0); y < std::min(int(y0 + cell), texture.rows); ++y)
        for (int x = int(x0); x < std::min(int(x0 + cell), texture.cols); ++x)
          if (texture(y, x) > best && region.contains({double(x), double(y)}))
            best = texture(y, x), at = {x, y};
      if (at.x < 0) continue;
      const Eigen::Vector2d px(at.x, at.y);
      const auto local = surface.around(px, 1.5 * half_window_px_);
      if (!local || !(local->inverseDepth(px) > 0)) continue;
      const auto lift = [&](const Eigen::Vector2d& p) -> Eigen::Vector3d {
        return cameras::undistort(rig.left, p).homogeneous() / local->inverseDepth(p);
      };
      const double h = 0.5 * half_window_px_;
      const Eigen::Vector3d across = lift(px + Eigen::Vector2d(h, 0)) - lift(px - Eigen::Vector2d(h, 0)),
                            down = lift(px + Eigen::Vector2d(0, h)) - lift(px - Eigen::Vector2d(0, h));
      const SkinPart part = mobility.at(px);
      SkinPoint point{lift(px), down.cross(across).normalized(), part.sigma_mm, 0, part.number};
      if (!point.mm.allFinite() || !point.normal.allFinite()) continue;
      point.region = region.partAt(px);
      points_.push_back(point);
    }
  for (const auto& point : points_) centre_mm_ += point.mm / double(points_.size());
}

int SkinPoints::regionCount() const { return FaceRegion::kPartColumns * FaceRegion::kPartRows; }

bool SkinPoints::isSeen(std::size_t i, int c, const SkinView& then, const cameras::StereoRig& rig,
                        const Eigen::Isometry3d& camera_T_head) const {
  return facesCamera(points_[i], seenFrom(then.rig, c, then.camera_T_head)) &&
         facesCamera(points_[i], seenFrom(rig, c, camera_T_head));
}

std::vector<SkinMatch> SkinPoints::find(const SkinView& then, const cameras::StereoRig& rig,
                                        const RecoveryPictures& now, const Eigen::Isometry3d& camera_T_head,
                                        const SkinSearch& search) const {
  const double scale = 1.0 / (1 << search.level);
  const int half = std::max(kLeastHalf_px, int(std::lround(half_window_px_ * std::max(scale, 0.5))));
  std::vector<SkinMatch> matches;
  for (int c = 0; c < 2; ++c) {
    const auto level = std::size_t(search.level), side = std::size_t(c);
    const Sight before{&cameraOf(then.rig, c), seenFrom(then.rig, c, then.camera_T_head),
                       &then.pictures.level[level][side]},
        after{&cameraOf(rig, c), seenFrom(rig, c, camera_T_head), &now.level[level][side]};
    for (std::size_t i = 0; i < points_.size(); i += std::size_t(search.every)) {
      if (!facesCamera(points_[i], before.camera_T_head) || !facesCamera(points_[i], after.camera_T_head))
        continue;
      auto match = findPoint(points_[i], before, after, scale, half, search.reach_px);
      if (!match) continue;
      match->point = int(i), match->camera = c;
      match->jacobian.leftCols<3>() = match->jacobian.rightCols<3>() * -skew(points_[i].mm - centre_mm_);
      matches.push_back(*match);
    }
  }
  return matches;
}

cameras::StereoFrame SkinPoints::faceOnly(const cameras::StereoFrame& frame, const cameras::StereoRig& rig,
                                          const Eigen::Isometry3d& camera_T_head) const {
  cameras::StereoFrame face = frame;
  const int margin = kMarginWindows * half_window_px_;
  for (const int c : {0, 1}) {
    cv::Mat& picture = c == 0 ? face.left : face.right;
    std::vector<cv::Point> places;
    for (const auto& point : points_) {
      const Eigen::Vector2d px =
          cameras::project(cameraOf(rig, c), seenFrom(rig, c, camera_T_head) * point.mm);
      places.emplace_back(int(px.x()), int(px.y()));
    }
    if (places.empty()) continue;
    cv::Rect box = cv::boundingRect(places);
    box = cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
          cv::Rect({}, picture.size());
    cv::Mat black(picture.size(), picture.type(), cv::Scalar(0));
    if (box.area() > 0) picture(box).copyTo(black(box));
    picture = black;
  }
  return face;
}

}  // namespace facenav::head_tracking
