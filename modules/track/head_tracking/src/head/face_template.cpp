#include "face_template.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"
#include "patch_placement.h"
#include "search_kernel.h"

namespace facenav::head_tracking {
namespace {

constexpr float kLeastContrast = 0.03f;  // relative to the mean grey; limits noise on flatter skin
constexpr double kWanted = 350;          // number of points over the region's box
constexpr double kSurfaceRadius_px = 9.0;
constexpr double kHiddenBehind_mm = 12.0;  // behind the nearest skin within one coarsest pixel
constexpr int kSteps[2] = {5, 4};          // steps per level
constexpr std::size_t kEvery[2] = {2, 1};  // every n-th point is used, per level
constexpr float kReach = 1.5f;  // reach of a residual's robust weight, in local standard deviations

// Bilinear value; nothing outside the image.
std::optional<float> sampled(const cv::Mat1f& image, double x, double y) {
  if (!(x >= 0 && y >= 0 && x < image.cols - 1 && y < image.rows - 1)) return std::nullopt;
  const int ix = int(x), iy = int(y);
  const float fx = float(x - ix), fy = float(y - iy);
  const float *a = image[iy] + ix, *b = image[iy + 1] + ix;
  const float top = a[0] + fx * (a[1] - a[0]), low = b[0] + fx * (b[1] - b[0]);
  return top + fy * (low - top);
}

double facing(const FaceTemplate::Point& point, const Eigen::Isometry3d& camera_T_head) {
  return -(camera_T_head.linear() * point.normal).dot((camera_T_head * point.mm).normalized());
}

const cameras::CameraModel& cameraOf(const cameras::StereoRig& rig, int camera) {
  return camera == 0 ? rig.left : rig.right;
}

Eigen::Isometry3d seenFrom(const cameras::StereoRig& rig, int camera, const Eigen::Isometry3d& motion) {
  return camera == 0 ? motion : rig.right_T_left.isometry() * motion;
}

}  // namespace

cv::Mat1f evened(const BlurredImage& level) {
  cv::Mat1w wider;
  cv::copyMakeBorder(level.pixels, wider, search::kRim, search::kRim, search::kRim, search::kRim,
                     cv::BORDER_REFLECT_101);
  cv::Mat1f result(level.pixels.size());
  std::vector<std::int32_t> scratch(6 * std::size_t(result.cols + search::kWindow + search::kLanes));
  search::Evening task;
  task.from = wider.ptr<std::uint16_t>(), task.from_stride = int(wider.step1());
  task.columns = result.cols, task.rows = result.rows;
  task.least_contrast = 1.f, task.per_mean = kLeastContrast;
  task.scratch = scratch.data();
  task.to = result.ptr<float>(), task.to_stride = int(result.step1());
  search::kernel().even(task);
  return result;
}

EvenedPair::EvenedPair(const std::array<ImagePyramid, 2>& now) {
  for (std::size_t l = 0; l < kLevel.size(); ++l)
    for (int c = 0; c < 2; ++c) image[l][c] = evened(now[c].level[kLevel[l]]);
}

FaceTemplate::FaceTemplate(const cameras::StereoRig& rig, const FaceRegion& region,
                           const FaceSurface& surface, const Eigen::Vector3d& centre_mm)
    : centre_mm_(centre_mm) {
  const cv::Rect box = region.box();
  const int spacing_px = std::max(1, int(std::sqrt(box.area() / kWanted)));
  for (int y = box.y; y < box.br().y; y += spacing_px)
    for (int x = box.x; x < box.br().x; x += spacing_px) {
      const Eigen::Vector2d px(x, y);
      if (!region.contains(px)) continue;
      const auto local = surface.around(px, kSurfaceRadius_px);
      if (!local) continue;
      const auto lift = [&](double u, double v) -> Eigen::Vector3d {
        const Eigen::Vector2d at = px + Eigen::Vector2d(u, v);
        return cameras::undistort(rig.left, at).homogeneous() / std::max(1e-6, local->inverseDepth(at));
      };
      const Eigen::Vector3d across = lift(2, 0) - lift(-2, 0), down = lift(0, 2) - lift(0, -2);
      points_.push_back({lift(0, 0), down.cross(across).normalized()});
    }
}

std::vector<bool> FaceTemplate::seenBy(const cameras::CameraModel& camera,
                                       const Eigen::Isometry3d& camera_T_head) const {
  std::vector<bool> is_seen(points_.size(), false);
  std::vector<cv::Point> cell(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d now_mm = camera_T_head * points_[i].mm;
    if (now_mm.z() < 1 || facing(points_[i], camera_T_head) < kGrazing_cos) continue;
    const Eigen::Vector2d px = cameras::project(camera, now_mm) / kCoarsestStep;
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
  cv::erode(nearest_mm, nearest_mm, {});  // minimum of each cell and its neighbours
  for (std::size_t i = 0; i < points_.size(); ++i)
    is_seen[i] = is_seen[i] && depth_mm(i) < nearest_mm(cell[i] - all.tl()) + kHiddenBehind_mm;
  return is_seen;
}

FaceTemplate::Appearance FaceTemplate::appearanceAt(const cameras::StereoRig& rig, const EvenedPair& images,
                                                    const Eigen::Isometry3d& motion) const {
  Appearance appearance;
  for (int c = 0; c < 2; ++c) {
    const Eigen::Isometry3d camera_T_head = seenFrom(rig, c, motion);
    const auto is_seen = seenBy(cameraOf(rig, c), camera_T_head);
    for (std::size_t l = 0; l < 2; ++l) {
      const double scale = 1.0 / (1 << EvenedPair::kLevel[l]);
      auto& grey = appearance.grey[l][c];
      grey.resize(points_.size());
      for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!is_seen[i]) continue;
        const Eigen::Vector2d px = scale * cameras::project(cameraOf(rig, c), camera_T_head * points_[i].mm);
        if (const auto here = sampled(images.image[l][c], px.x(), px.y()))
          grey[i] = {*here, float(facing(points_[i], camera_T_head))};
      }
    }
  }
  return appearance;
}

FaceTemplate::Sums& FaceTemplate::Sums::operator+=(const Sums& other) {
  normal += other.normal, pull += other.pull;
  product += other.product, now_squares += other.now_squares, then_squares += other.then_squares;
  seen += other.seen;
  return *this;
}

FaceTemplate::ExpectedPoints FaceTemplate::expectedPoints(const cameras::StereoRig& rig,
                                                          const Appearance& appearance, std::size_t l, int c,
                                                          const Eigen::Isometry3d& motion) const {
  const double scale = 1.0 / (1 << EvenedPair::kLevel[l]);
  const Eigen::Isometry3d camera_T_head = seenFrom(rig, c, motion);
  ExpectedPoints expected;
  for (std::size_t i = 0; i < points_.size(); i += kEvery[l]) {
    const Appearance::Grey& then = appearance.grey[l][c][i];
    const Eigen::Vector3d now_mm = camera_T_head * points_[i].mm;
    if (then.weight <= 0 || now_mm.z() < 1) continue;
    Eigen::Matrix<double, 2, 3> d_p;
    const Eigen::Vector2d px = scale * cameras::project(cameraOf(rig, c), now_mm, d_p);
    const Eigen::Matrix2d d = scale * now_mm.z() * d_p.leftCols<2>();
    expected.add(points_[i], then, d, px - d * now_mm.hnormalized());
  }
  return expected;
}

void FaceTemplate::ExpectedPoints::add(const Point& point, const Appearance::Grey& then,
                                       const Eigen::Matrix2d& d, const Eigen::Vector2d& offset) {
  using F = search::TemplateField;
  const int lane = count_++ % search::kLanes;
  if (lane == 0) blocks_.resize(blocks_.size() + F::count * search::kLanes, 0.f);
  float* to = &blocks_[blocks_.size() - F::count * search::kLanes] + lane;
  const auto set = [&](int field, double value) { to[field * search::kLanes] = float(value); };
  set(F::x, point.mm.x()), set(F::y, point.mm.y()), set(F::z, point.mm.z());
  set(F::normal_x, point.normal.x()), set(F::normal_y, point.normal.y()), set(F::normal_z, point.normal.z());
  set(F::value, then.value), set(F::weight, then.weight);
  set(F::d00, d(0, 0)), set(F::d01, d(0, 1)), set(F::d10, d(1, 0)), set(F::d11, d(1, 1));
  set(F::u0, offset.x()), set(F::v0, offset.y());
}

FaceTemplate::Sums FaceTemplate::ExpectedPoints::sumsIn(const cv::Mat1f& image,
                                                        const Eigen::Isometry3d& camera_T_head,
                                                        const Eigen::Vector3d& centre_mm) const {
  search::TemplateView view;
  view.blocks = blocks_.data();
  view.block_count = int(blocks_.size()) / (search::TemplateField::count * search::kLanes);
  view.image = image.ptr<float>(), view.stride = int(image.step1());
  view.width = image.cols, view.height = image.rows;
  const auto pose = floatsOf(camera_T_head);
  std::copy(pose.begin(), pose.end(), view.camera_T_head);
  for (int i = 0; i < 3; ++i) view.centre[i] = float(centre_mm[i]);
  view.least_facing = float(kGrazing_cos), view.reach = kReach;
  const search::TemplateSums seen = search::kernel().sum(view);
  Sums sums;
  for (int i = 0, n = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) sums.normal(i, j) = sums.normal(j, i) = seen.normal[n++];
    sums.pull(i) = seen.pull[i];
  }
  sums.product = seen.product, sums.now_squares = seen.now_squares, sums.then_squares = seen.then_squares;
  sums.seen = seen.seen;
  return sums;
}

FaceTemplate::Fit FaceTemplate::fit(const cameras::StereoRig& rig, const Appearance& appearance,
                                    const EvenedPair& now, const Eigen::Isometry3d& start) const {
  Fit fit{start, 0.0};
  for (std::size_t l = 0; l < 2; ++l) {
    const std::array<ExpectedPoints, 2> expected = {expectedPoints(rig, appearance, l, 0, fit.motion),
                                                    expectedPoints(rig, appearance, l, 1, fit.motion)};
    for (int step = 0; step < kSteps[l]; ++step) {
      Sums sums;
      for (int c = 0; c < 2; ++c)
        sums += expected[c].sumsIn(now.image[l][c], seenFrom(rig, c, fit.motion), centre_mm_);
      if (sums.seen < double(kFewestPoints)) return {fit.motion, 0.0};
      fit.likeness = sums.product / std::sqrt(std::max(1e-9, sums.now_squares * sums.then_squares));
      sums.normal.diagonal() *= 1.01;
      const Vector6d xi = solveSymmetric(sums.normal, sums.pull);
      if (!xi.allFinite()) return {fit.motion, 0.0};
      fit.motion =
          fit.motion * Eigen::Translation3d(centre_mm_) * expRigid(xi) * Eigen::Translation3d(-centre_mm_);
    }
  }
  return fit;
}

}  // namespace facenav::head_tracking
