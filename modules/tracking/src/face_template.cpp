#include "face_template.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "facenav/geometry/rotation.h"

namespace facenav::tracking {
namespace {

constexpr int kWindow_px = 11;           // of a level, over which light is evened
constexpr float kLeastContrast = 0.03f;  // of the mean grey: flatter skin is not made to look rough
constexpr double kWanted = 350;          // points over the region's box
constexpr int kLeastSpacing_px = 6;      // of the points, in the left reference image
constexpr double kSurfaceRadius_px = 9.0;
constexpr double kLeastFacing = 0.2;       // cosine of view against normal
constexpr double kHiddenBehind_mm = 12.0;  // the nearest skin seen within one pixel of the coarsest level
constexpr int kSteps[2] = {5, 4};          // by level
constexpr double kSettled_mm = 0.5;        // what follows finds the rest
constexpr std::size_t kEvery[2] = {2, 1};  // of the points, by level
constexpr float kReach = 1.5f;             // of a residual's robust weight, local standard deviations
constexpr std::size_t kFewest = 40;        // points in both images together

struct Sampled {
  float value, d_x, d_y;
};

// Bilinear, with its own slopes; nothing outside.
std::optional<Sampled> sampled(const cv::Mat1f& image, double x, double y) {
  if (!(x >= 0 && y >= 0 && x < image.cols - 1 && y < image.rows - 1)) return std::nullopt;
  const int ix = int(x), iy = int(y);
  const float fx = float(x - ix), fy = float(y - iy);
  const float *a = image[iy] + ix, *b = image[iy + 1] + ix;
  const float top = a[0] + fx * (a[1] - a[0]), low = b[0] + fx * (b[1] - b[0]);
  return Sampled{top + fy * (low - top), (1 - fy) * (a[1] - a[0]) + fy * (b[1] - b[0]), low - top};
}

double facing(const FaceTemplate::Point& point, const Eigen::Isometry3d& camera_T_head) {
  return -(camera_T_head.linear() * point.normal).dot((camera_T_head * point.mm).normalized());
}

const stereo::CameraModel& cameraOf(const stereo::StereoRig& rig, int camera) {
  return camera == 0 ? rig.left : rig.right;
}

Eigen::Isometry3d seenFrom(const stereo::StereoRig& rig, int camera, const Eigen::Isometry3d& motion) {
  return camera == 0 ? motion : rig.right_T_left.isometry() * motion;
}

}  // namespace

cv::Mat1f evened(const BlurredImage& level) {
  const cv::Mat1f grey = greyOf(level);
  cv::Mat1f mean, squares, result(grey.size());
  cv::boxFilter(grey, mean, CV_32F, {kWindow_px, kWindow_px});
  cv::sqrBoxFilter(grey, squares, CV_32F, {kWindow_px, kWindow_px});
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x) {
      const float m = mean(y, x), least = 1.f + kLeastContrast * m;
      result(y, x) = (grey(y, x) - m) / std::sqrt(std::max(0.f, squares(y, x) - m * m) + least * least);
    }
  return result;
}

EvenedPair::EvenedPair(const std::array<ImagePyramid, 2>& now) {
  for (std::size_t l = 0; l < kLevel.size(); ++l)
    for (int c = 0; c < 2; ++c) image[l][c] = evened(now[c].level[kLevel[l]]);
}

FaceTemplate::FaceTemplate(const stereo::StereoRig& rig, const FaceRegion& region, const FaceSurface& surface,
                           const Eigen::Vector3d& centre_mm)
    : centre_mm_(centre_mm) {
  const cv::Rect box = region.box();
  const int spacing_px = std::max(kLeastSpacing_px, int(std::sqrt(box.area() / kWanted)));
  for (int y = box.y; y < box.br().y; y += spacing_px)
    for (int x = box.x; x < box.br().x; x += spacing_px) {
      const Eigen::Vector2d px(x, y);
      if (!region.contains(px)) continue;
      const auto local = surface.around(px, kSurfaceRadius_px);
      if (!local) continue;
      const auto lift = [&](double u, double v) -> Eigen::Vector3d {
        const Eigen::Vector2d at = px + Eigen::Vector2d(u, v);
        return stereo::undistort(rig.left, at).homogeneous() / std::max(1e-6, local->inverseDepth(at));
      };
      const Eigen::Vector3d across = lift(2, 0) - lift(-2, 0), down = lift(0, 2) - lift(0, -2);
      points_.push_back({lift(0, 0), down.cross(across).normalized()});
    }
}

std::vector<bool> FaceTemplate::seenBy(const stereo::CameraModel& camera,
                                       const Eigen::Isometry3d& camera_T_head) const {
  constexpr double kCell = 1.0 / kCoarsestStep;
  std::vector<bool> is_seen(points_.size(), false);
  std::vector<cv::Point> cell(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d now_mm = camera_T_head * points_[i].mm;
    if (now_mm.z() < 1 || facing(points_[i], camera_T_head) < kLeastFacing) continue;
    const Eigen::Vector2d px = kCell * stereo::project(camera, now_mm);
    if (px.cwiseAbs().maxCoeff() > 1e4) continue;
    cell[i] = {int(std::lround(px.x())), int(std::lround(px.y()))};
    is_seen[i] = true;
  }
  const cv::Rect all = cv::boundingRect(cell);
  cv::Mat1f nearest_mm(all.height, all.width, std::numeric_limits<float>::max());
  const auto depth_mm = [&](std::size_t i) { return float((camera_T_head * points_[i].mm).z()); };
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (is_seen[i]) {
      float& nearest = nearest_mm(cell[i] - all.tl());
      nearest = std::min(nearest, depth_mm(i));
    }
  cv::erode(nearest_mm, nearest_mm, {});  // the least of each cell and its neighbours
  for (std::size_t i = 0; i < points_.size(); ++i)
    is_seen[i] = is_seen[i] && depth_mm(i) < nearest_mm(cell[i] - all.tl()) + kHiddenBehind_mm;
  return is_seen;
}

FaceTemplate::Looks FaceTemplate::looksAt(const stereo::StereoRig& rig, const EvenedPair& images,
                                          const Eigen::Isometry3d& motion) const {
  Looks looks;
  for (int c = 0; c < 2; ++c) {
    const Eigen::Isometry3d camera_T_head = seenFrom(rig, c, motion);
    const auto is_seen = seenBy(cameraOf(rig, c), camera_T_head);
    for (std::size_t l = 0; l < 2; ++l) {
      const double scale = 1.0 / (1 << EvenedPair::kLevel[l]);
      auto& grey = looks.grey[l][c];
      grey.resize(points_.size());
      for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!is_seen[i]) continue;
        const Eigen::Vector2d px = scale * stereo::project(cameraOf(rig, c), camera_T_head * points_[i].mm);
        if (const auto here = sampled(images.image[l][c], px.x(), px.y()))
          grey[i] = {here->value, float(facing(points_[i], camera_T_head))};
      }
    }
  }
  return looks;
}

FaceTemplate::Fit FaceTemplate::fit(const stereo::StereoRig& rig, const Looks& looks, const EvenedPair& now,
                                    const Eigen::Isometry3d& start) const {
  Fit fit{start, 0.0};
  for (std::size_t l = 0; l < 2; ++l) {
    const double scale = 1.0 / (1 << EvenedPair::kLevel[l]);
    for (int step = 0; step < kSteps[l]; ++step) {
      Matrix6d h = Matrix6d::Zero();
      Vector6d g = Vector6d::Zero();
      double products = 0, now_squares = 0, then_squares = 0;
      std::size_t seen = 0;
      for (int c = 0; c < 2; ++c) {
        const Eigen::Isometry3d camera_T_head = seenFrom(rig, c, fit.motion);
        for (std::size_t i = 0; i < points_.size(); i += kEvery[l]) {
          const Looks::Grey& then = looks.grey[l][c][i];
          if (then.weight <= 0) continue;
          const Eigen::Vector3d now_mm = camera_T_head * points_[i].mm;
          const double towards = facing(points_[i], camera_T_head);
          if (towards < kLeastFacing || now_mm.z() < 1) continue;
          Eigen::Matrix<double, 2, 3> d_p;
          const Eigen::Vector2d px = scale * stereo::project(cameraOf(rig, c), now_mm, d_p);
          const auto here = sampled(now.image[l][c], px.x(), px.y());
          if (!here) continue;
          const float e = then.value - here->value, q = e / kReach;
          const double w = std::min(double(then.weight), towards) / (1.0 + q * q);
          const Eigen::RowVector3d d_x =
              scale * Eigen::RowVector2d(here->d_x, here->d_y) * d_p * camera_T_head.linear();
          Vector6d j;
          j << (points_[i].mm - centre_mm_).cross(d_x.transpose()), d_x.transpose();
          h.selfadjointView<Eigen::Lower>().rankUpdate(j, w);
          g += w * e * j;
          products += w * then.value * here->value;
          now_squares += w * here->value * here->value, then_squares += w * then.value * then.value;
          ++seen;
        }
      }
      if (seen < kFewest) return {fit.motion, 0.0};
      fit.likeness = products / std::sqrt(std::max(1e-9, now_squares * then_squares));
      const Matrix6d whole = h.selfadjointView<Eigen::Lower>();
      Matrix6d damped = whole;
      damped.diagonal() *= 1.01;
      const Vector6d xi = damped.ldlt().solve(g);
      if (!xi.allFinite()) return {fit.motion, 0.0};
      fit.motion =
          fit.motion * Eigen::Translation3d(centre_mm_) * expRigid(xi) * Eigen::Translation3d(-centre_mm_);
      if (xi.tail<3>().norm() + 80.0 * xi.head<3>().norm() < kSettled_mm) break;
    }
  }
  return fit;
}

}  // namespace facenav::tracking
