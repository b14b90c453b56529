#include "facenav/monitoring/surface_beside_coil.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::monitoring {
namespace {

constexpr double kSample_mm = 4.0;
constexpr std::size_t kFewestSkin = 40;  // sampled points: a patch of about 6 cm2
constexpr std::size_t kFewestPoints = 300;
constexpr double kAbovePlate_mm = 4.0;  // anything higher than the plate is the coil or a hand
constexpr int kMargin_px = 12, kLeastBox_px = 40;
constexpr double kTile_mm = 8.0;  // stereo errors within such a patch are correlated

double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double share = std::clamp((p - a).dot(along) / std::max(1e-9, along.squaredNorm()), 0.0, 1.0);
  return (a + share * along - p).norm();
}

/// Signed distance from the closed outline: > 0 outside, < 0 inside.
double outsideOutline_mm(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& p) {
  double least_mm = std::numeric_limits<double>::max();
  bool is_inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const auto &a = outline[i], &b = outline[j];
    least_mm = std::min(least_mm, distanceToSegment(p, a, b));
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      is_inside = !is_inside;
  }
  return is_inside ? -least_mm : least_mm;
}

BesideCoilFinding unseen(const char* why) {
  BesideCoilFinding finding;
  finding.unseen = why;
  return finding;
}

std::vector<std::size_t> sampleOf(const std::vector<Eigen::Vector3d>& points_mm) {
  std::map<std::tuple<int, int, int>, std::size_t> cells;
  for (std::size_t i = 0; i < points_mm.size(); ++i) {
    const Eigen::Vector3d at = (points_mm[i] / kSample_mm).array().floor();
    cells.try_emplace({int(at.x()), int(at.y()), int(at.z())}, i);
  }
  std::vector<std::size_t> sample;
  for (const auto& cell : cells) sample.push_back(cell.second);
  return sample;
}

}  // namespace

SurfaceBesideCoil::SurfaceBesideCoil(const cameras::StereoRig& rig,
                                     std::shared_ptr<const registration::ScalpField> scalp,
                                     std::vector<Eigen::Vector2d> outline_mm)
    : rig_(rig), scalp_(std::move(scalp)), outline_mm_(std::move(outline_mm)) {
  FACENAV_EXPECT(scalp_ != nullptr && outline_mm_.size() >= 3, "a scalp and an outline are needed");
  sample_ = sampleOf(scalp_->skin().points.points_mm);
}

bool SurfaceBesideCoil::isBeside(const Eigen::Vector3d& p_coil_mm) const {
  if (p_coil_mm.z() < -kAbovePlate_mm) return false;
  const double off_mm = outsideOutline_mm(outline_mm_, p_coil_mm.head<2>());
  return off_mm > kNearest_mm && off_mm < kFarthest_mm;
}

bool SurfaceBesideCoil::isInBoth(const Eigen::Vector3d& p_camera_mm) const {
  const auto isIn = [&](const cameras::CameraModel& camera, const Eigen::Vector3d& p_mm) {
    if (p_mm.z() < 50) return false;
    const Eigen::Vector2d px = cameras::project(camera, p_mm);
    return px.x() > 0 && px.y() > 0 && px.x() < rig_.width_px - 1 && px.y() < rig_.height_px - 1;
  };
  return isIn(rig_.left, p_camera_mm) && isIn(rig_.right, rig_.right_T_left.isometry() * p_camera_mm);
}

SurfaceBesideCoil::Band SurfaceBesideCoil::bandOf(const RigidTransform<Camera, Mri>& camera_T_mri,
                                                  const RigidTransform<Camera, Coil>& camera_T_coil) const {
  Band band;
  const auto& skin = scalp_->skin().points;
  const Eigen::Isometry3d pose = camera_T_mri.isometry(),
                          coil_T_mri = (camera_T_coil.inverse() * camera_T_mri).isometry();
  const Eigen::Vector3d right_eye_mm = rig_.right_T_left.inverse().translation_mm();
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  band.nearest_mm = 1e9;
  for (const std::size_t i : sample_) {
    // Excludes the far side of the head, which also lies under the plate's outline.
    const Eigen::Vector3d p_coil_mm = coil_T_mri * skin.points_mm[i];
    if (p_coil_mm.z() > 2 * kFarthest_mm || !isBeside(p_coil_mm)) continue;
    const Eigen::Vector3d p_mm = pose * skin.points_mm[i], normal = pose.linear() * skin.normals[i];
    const auto faces = [&](const Eigen::Vector3d& eye_mm) {
      return normal.dot(eye_mm - p_mm) > kObliqueSkin_cos * (eye_mm - p_mm).norm();
    };
    if (!faces(Eigen::Vector3d::Zero()) || !faces(right_eye_mm) || !isInBoth(p_mm)) continue;
    band.skin_mm.push_back(p_mm);
    const Eigen::Vector2d px = cameras::project(rig_.left, p_mm);
    low = low.cwiseMin(px), high = high.cwiseMax(px);
    band.nearest_mm = std::min(band.nearest_mm, p_mm.z());
    band.farthest_mm = std::max(band.farthest_mm, p_mm.z());
  }
  if (band.skin_mm.empty()) return band;
  const cv::Point margin(kMargin_px, kMargin_px);
  band.box = cv::Rect(cv::Point(int(low.x()), int(low.y())) - margin,
                      cv::Point(int(high.x()), int(high.y())) + margin) &
             cv::Rect(0, 0, rig_.width_px, rig_.height_px);
  return band;
}

BesideCoilFinding SurfaceBesideCoil::measure(const cameras::StereoFrame& frame,
                                             const RigidTransform<Camera, Mri>& camera_T_mri,
                                             const RigidTransform<Camera, Coil>& camera_T_coil) const {
  const Band band = bandOf(camera_T_mri, camera_T_coil);
  if (band.skin_mm.size() < kFewestSkin || band.box.width < kLeastBox_px || band.box.height < kLeastBox_px)
    return unseen("no skin beside the coil faces both cameras");
  auto options = stereo::plainFaceOptions();
  options.left_roi = band.box;
  options.nearest_mm = std::max(50.0, band.nearest_mm - kDepthMargin_mm);
  options.farthest_mm = band.farthest_mm + kDepthMargin_mm;
  options.match.smallest_patch_px = 300;
  stereo::FaceCloud cloud;
  try {
    TaskMonitor monitor;
    cloud = stereo::measureFace(rig_, frame, options, monitor);
  } catch (const Error&) {
    return unseen("too little texture beside the coil");
  }
  const auto coil_T_camera = camera_T_coil.inverse().isometry(),
             mri_T_camera = camera_T_mri.inverse().isometry();
  std::vector<double> heights_mm;
  std::map<std::tuple<int, int, int>, int> tiles;
  double common_mm = 0;
  for (std::size_t i = 0; i < cloud.cloud.size(); ++i) {
    const Eigen::Vector3d& p_mm = cloud.cloud.points_mm[i];
    if (!isBeside(coil_T_camera * p_mm)) continue;
    const auto skin = scalp_->fine((mri_T_camera * p_mm).cast<float>());
    if (!(std::abs(skin.distance_mm) < float(kReach_mm))) continue;
    const Eigen::Vector3d outward = mri_T_camera.linear().transpose() * skin.gradient.cast<double>();
    const double facing = -outward.dot(p_mm) / p_mm.norm();
    if (facing < kObliqueSkin_cos) continue;
    heights_mm.push_back(skin.distance_mm);
    const Eigen::Vector3d tile = (p_mm / kTile_mm).array().floor();
    ++tiles[{int(tile.x()), int(tile.y()), int(tile.z())}];
    // Depth error that neighbouring points of plain skin share, along the skin's normal.
    common_mm +=
        facing * stereo::kPlainSkinError_px * p_mm.z() * p_mm.z() / (rig_.left.k(0, 0) * rig_.baseline_mm());
  }
  if (heights_mm.size() < kFewestPoints) return unseen("too few points of skin beside the coil");
  BesideCoilFinding finding;
  finding.has_measured = true;
  finding.points = int(heights_mm.size());
  finding.above_skin_mm = median(heights_mm);
  for (double& height : heights_mm) height = std::abs(height - finding.above_skin_mm);
  const double spread_mm = kSigmaPerMad * median(heights_mm);
  finding.sigma_mm =
      std::hypot(common_mm / finding.points, kMedianNoise * spread_mm / std::sqrt(double(tiles.size())));
  return finding;
}

BesideCoilWatch::BesideCoilWatch(Measure measure, Mode mode)
    : checks_(
          [measure = std::move(measure)](const Question& question) {
            return Answer{question.frame->captured.s,
                          question.camera_T_mri.inverse() * question.camera_T_coil, measure(question)};
          },
          mode) {}

void BesideCoilWatch::add(std::shared_ptr<const cameras::StereoFrame> frame,
                          const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri,
                          const std::optional<RigidTransform<Camera, Coil>>& camera_T_coil) {
  const double now_s = frame->captured.s;
  if (const auto answer = checks_.take(now_s)) answer_ = answer;
  shown_.reset();
  if (!camera_T_mri || !camera_T_coil) return;
  const auto mri_T_coil = camera_T_mri->inverse() * *camera_T_coil;
  if (answer_ && std::abs(now_s - answer_->captured_s) < kHolds_s &&
      (mri_T_coil.translation_mm() - answer_->mri_T_coil.translation_mm()).norm() < kHolds_mm)
    shown_ = answer_->finding;
  const bool is_due = !asked_s_ || std::abs(now_s - *asked_s_) >= DriftWatchdog::kInterval_s;
  if (!is_due || checks_.isBusy()) return;
  asked_s_ = now_s;
  checks_.ask(std::make_shared<const Question>(Question{std::move(frame), *camera_T_mri, *camera_T_coil}),
              now_s);
}

}  // namespace facenav::monitoring
