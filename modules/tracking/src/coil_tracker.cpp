#include "facenav/tracking/coil_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/geometry/rigid_fit.h"
#include "marker_detection.h"
#include "marker_fit.h"

namespace facenav::tracking {
namespace {

using CoilToCamera = RigidTransform<Camera, Coil>;

// When a fit counts as the coil. The misfit of a side's mean (bias) is what a wrong pair, a moved camera or a
// swapped pair make; calibrations leave 0.1-0.3 px of it.
constexpr double kMostBias_px = 0.6, kMostRms_px = 0.8, kLeastInlierFraction = 0.6;
// The print's inner edges tell its size from what blur and gamma do, so a size that is off means a wrong
// depth (a camera turned along the epipolar lines shows in nothing else). Before the fit, corners tell it
// less well.
constexpr double kMostSizeError = 0.02, kMostSizeErrorOfCorners = 0.04, kMostShrink_px = 1.5;
constexpr double kMostRotationSigma_rad = 0.02, kMostTranslationSigma_mm = 1.5;
constexpr double kLeastDepth_mm = 50.0, kMostDepth_mm = 5000.0;

std::array<Eigen::Vector3d, 4> cornersInMarker_mm(double size_mm) {
  const double h = size_mm / 2;
  return {Eigen::Vector3d(-h, -h, 0), Eigen::Vector3d(h, -h, 0), Eigen::Vector3d(h, h, 0),
          Eigen::Vector3d(-h, h, 0)};
}

bool isUsable(const cv::Mat& grey, const stereo::StereoRig& rig) {
  return grey.type() == CV_8UC1 && grey.cols == rig.width_px && grey.rows == rig.height_px;
}

/// All of one grey: covered, unplugged or black.
bool isBlank(const cv::Mat& grey) {
  double low = 0, high = 0;
  cv::minMaxLoc(grey, &low, &high);
  return high - low < 10.0;
}

double longestSide_px(const Quad& quad) {
  double longest = 0;
  for (int i = 0; i < 4; ++i) longest = std::max(longest, (quad[(i + 1) % 4] - quad[i]).norm());
  return longest;
}

class MarkerCoilTracker final : public CoilTracker {
 public:
  void start(const stereo::StereoRig& rig, const CoilModel& coil) override;
  Tracked<CoilPose> track(const stereo::StereoFrame& frame) override;

 private:
  struct Candidate {
    std::vector<std::size_t> markers;  // the most certain first
    CoilToCamera start;
  };
  struct Solution {
    MarkerFit fit;
    std::size_t marker;
  };
  struct Search {
    std::vector<Solution> good;
    bool has_candidate = false;
  };

  std::optional<std::pair<cv::Rect, cv::Rect>> predictedWindows(const CoilToCamera& camera_T_coil) const;
  Search search(const stereo::StereoFrame& frame, const cv::Rect& left, const cv::Rect& right) const;
  Search fitAll(const stereo::StereoFrame& frame, const std::vector<Candidate>& candidates) const;
  std::vector<Candidate> pair(const std::vector<MarkerDetection>& left,
                              const std::vector<MarkerDetection>& right) const;
  std::optional<CoilToCamera> triangulatedPose(const MarkerDetection& left,
                                               const MarkerDetection& right) const;
  /// From one image alone, both poses that a plane allows; the other image decides.
  std::vector<Candidate> fromOneImage(const MarkerDetection& seen, bool is_left, const cv::Mat& other) const;
  std::optional<Quad> predictedCorners(std::size_t marker, const CoilToCamera& camera_T_coil,
                                       bool is_left) const;
  bool isSeenIn(const cv::Mat& grey, bool is_left, std::size_t marker,
                const CoilToCamera& camera_T_coil) const;
  /// The other markers of the coil that both images show where this pose puts them.
  void addOtherMarkers(const stereo::StereoFrame& frame, Candidate& candidate) const;
  bool isGood(const MarkerFit& fit, const Candidate& candidate) const;
  std::optional<CoilToCamera> predicted(double t_s) const;
  Tracked<CoilPose> accept(const Solution& solution, double t_s);

  stereo::StereoRig rig_;
  CoilModel coil_;
  std::vector<MarkerPattern> patterns_;
  struct Past {
    CoilToCamera camera_T_coil;
    double t_s;
  };
  std::optional<Past> last_, before_;
};

void MarkerCoilTracker::start(const stereo::StereoRig& rig, const CoilModel& coil) {
  if (coil.markers.empty()) throw Error("the coil has no marker", {}, "give one in coil.json");
  rig_ = rig;
  coil_ = coil;
  patterns_.clear();
  for (const MarkerModel& marker : coil.markers) patterns_.push_back(MarkerPattern::load(marker));
  last_.reset();
  before_.reset();
}

Tracked<CoilPose> MarkerCoilTracker::track(const stereo::StereoFrame& frame) {
  FACENAV_EXPECT(!patterns_.empty(), "track() before start()");
  Search result;
  if (!isUsable(frame.left, rig_) || !isUsable(frame.right, rig_)) {
    last_.reset();
    return Lost{LostReason::camera};
  }
  const double t_s = frame.captured.s;
  const auto prediction = predicted(t_s);
  if (prediction) {
    if (const auto windows = predictedWindows(*prediction))
      result = search(frame, windows->first, windows->second);
    if (result.good
            .empty()) {  // no quadrangle found (a finger at its edge, a hard shadow): look where it should be
      Candidate candidate{{}, *prediction};
      addOtherMarkers(frame, candidate);
      if (!candidate.markers.empty()) result = fitAll(frame, {candidate});
    }
  }
  if (result.good.empty()) {
    const cv::Rect all(0, 0, rig_.width_px, rig_.height_px);
    const Search full = search(frame, all, all);
    result.good = full.good;
    result.has_candidate = result.has_candidate || full.has_candidate;
  }
  if (result.good.size() == 1) return accept(result.good.front(), t_s);
  last_.reset();
  before_.reset();
  if (result.good.empty() && !result.has_candidate)
    return Lost{isBlank(frame.left) || isBlank(frame.right) ? LostReason::camera : LostReason::no_marker};
  return Lost{LostReason::high_residual};  // nothing fits, or the marker is there twice
}

std::optional<CoilToCamera> MarkerCoilTracker::predicted(double t_s) const {
  if (!last_) return std::nullopt;
  const double since_s = t_s - last_->t_s;
  if (since_s < 0 || since_s > 0.5) return std::nullopt;
  if (!before_ || last_->t_s - before_->t_s < 1e-4) return last_->camera_T_coil;
  const double factor = std::min(2.0, since_s / (last_->t_s - before_->t_s));
  const Eigen::Isometry3d& now = last_->camera_T_coil.isometry();
  const Eigen::Isometry3d& then = before_->camera_T_coil.isometry();
  Eigen::Isometry3d next = now;
  next.linear() = expRotation(factor * logRotation(now.linear() * then.linear().transpose())) * now.linear();
  next.translation() += factor * (now.translation() - then.translation());
  return CoilToCamera::fromIsometry(next);
}

std::optional<Quad> MarkerCoilTracker::predictedCorners(std::size_t marker, const CoilToCamera& camera_T_coil,
                                                        bool is_left) const {
  const Eigen::Isometry3d camera_T_marker = (camera_T_coil * coil_.markers[marker].coil_T_marker).isometry();
  const Eigen::Isometry3d view =
      (is_left ? Eigen::Isometry3d::Identity() : rig_.right_T_left.isometry()) * camera_T_marker;
  if (view.linear().col(2).dot(view.translation()) <= 0)
    return std::nullopt;  // its back is turned to this camera
  Quad quad;
  const auto corners_mm = cornersInMarker_mm(coil_.markers[marker].size_mm);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d p_mm = view * corners_mm[i];
    if (p_mm.z() < kLeastDepth_mm) return std::nullopt;
    quad[i] = stereo::project(is_left ? rig_.left : rig_.right, p_mm);
    if (!(quad[i].x() >= 0 && quad[i].y() >= 0 && quad[i].x() < rig_.width_px - 1 &&
          quad[i].y() < rig_.height_px - 1))
      return std::nullopt;
  }
  return quad;
}

std::optional<std::pair<cv::Rect, cv::Rect>> MarkerCoilTracker::predictedWindows(
    const CoilToCamera& camera_T_coil) const {
  std::array<cv::Rect, 2> windows;
  for (int image = 0; image < 2; ++image) {
    Eigen::AlignedBox2d box;
    double longest_px = 0;
    for (std::size_t marker = 0; marker < patterns_.size(); ++marker)
      if (const auto quad = predictedCorners(marker, camera_T_coil, image == 0)) {
        for (const auto& corner : *quad) box.extend(corner);
        longest_px = std::max(longest_px, longestSide_px(*quad));
      }
    if (box.isEmpty()) return std::nullopt;
    const double margin_px = 12 + 0.4 * longest_px;
    const cv::Point low(int(box.min().x() - margin_px), int(box.min().y() - margin_px));
    const cv::Point high(int(box.max().x() + margin_px), int(box.max().y() + margin_px));
    windows[image] = cv::Rect(low, high) & cv::Rect(0, 0, rig_.width_px, rig_.height_px);
  }
  return std::make_pair(windows[0], windows[1]);
}

MarkerCoilTracker::Search MarkerCoilTracker::search(const stereo::StereoFrame& frame, const cv::Rect& left,
                                                    const cv::Rect& right) const {
  const auto in_left = detectMarkers(frame.left, left, patterns_);
  const auto in_right = detectMarkers(frame.right, right, patterns_);
  std::vector<Candidate> candidates = pair(in_left, in_right);
  if (candidates.empty()) {
    for (const auto& seen : in_left)
      for (const auto& candidate : fromOneImage(seen, true, frame.right)) candidates.push_back(candidate);
    for (const auto& seen : in_right)
      for (const auto& candidate : fromOneImage(seen, false, frame.left)) candidates.push_back(candidate);
  }
  Search result = fitAll(frame, candidates);
  // Both images show the marker and yet no pose fits: say so.
  result.has_candidate = result.has_candidate || (!in_left.empty() && !in_right.empty());
  return result;
}

std::vector<MarkerCoilTracker::Candidate> MarkerCoilTracker::pair(
    const std::vector<MarkerDetection>& left, const std::vector<MarkerDetection>& right) const {
  std::vector<Candidate> candidates;
  for (const auto& l : left)
    for (const auto& r : right)
      if (l.marker == r.marker)
        if (const auto pose = triangulatedPose(l, r)) candidates.push_back({{l.marker}, *pose});
  return candidates;
}

std::optional<CoilToCamera> MarkerCoilTracker::triangulatedPose(const MarkerDetection& left,
                                                                const MarkerDetection& right) const {
  const double corner_px = 3.0;  // corners as detected, before refinement, with blur
  const auto model_mm = cornersInMarker_mm(coil_.markers[left.marker].size_mm);
  std::vector<Eigen::Vector3d> from_mm(model_mm.begin(), model_mm.end()), to_mm;
  for (int i = 0; i < 4; ++i) {
    if (stereo::epipolarError_px(rig_, left.corners[i], right.corners[i]) > corner_px) return std::nullopt;
    to_mm.push_back(stereo::triangulate(rig_, left.corners[i], right.corners[i]).mm);
    if (!to_mm.back().allFinite() || to_mm.back().z() < kLeastDepth_mm || to_mm.back().z() > kMostDepth_mm)
      return std::nullopt;
  }
  // The size that stereo sees must be the print's, else the pair is wrong (left and right swapped, two
  // markers).
  double seen_mm = 0;
  for (int i = 0; i < 4; ++i) seen_mm += (to_mm[(i + 1) % 4] - to_mm[i]).norm() / 4;
  const double nominal_mm = coil_.markers[left.marker].size_mm;
  const double side_px = std::min(longestSide_px(left.corners), longestSide_px(right.corners));
  if (std::abs(seen_mm / nominal_mm - 1.0) > kMostSizeErrorOfCorners + 2.5 / side_px) return std::nullopt;
  const auto pose = RigidTransform<Camera, Marker>::fromIsometry(fitRigidPoints(from_mm, to_mm).to_T_from);
  return pose * coil_.markers[left.marker].coil_T_marker.inverse();
}

std::vector<MarkerCoilTracker::Candidate> MarkerCoilTracker::fromOneImage(const MarkerDetection& seen,
                                                                          bool is_left,
                                                                          const cv::Mat& other) const {
  std::vector<cv::Point3d> model;
  std::vector<cv::Point2d> image;
  for (const auto& p_mm : cornersInMarker_mm(coil_.markers[seen.marker].size_mm))
    model.emplace_back(p_mm.x(), p_mm.y(), p_mm.z());
  for (const auto& corner : seen.corners) {
    const Eigen::Vector2d n = stereo::undistort(is_left ? rig_.left : rig_.right, corner);
    image.emplace_back(n.x(), n.y());
  }
  std::vector<cv::Vec3d> rotations, translations;
  cv::solvePnPGeneric(model, image, cv::Matx33d::eye(), cv::noArray(), rotations, translations, false,
                      cv::SOLVEPNP_IPPE);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    Eigen::Isometry3d view_T_marker = Eigen::Isometry3d::Identity();
    view_T_marker.linear() = expRotation({rotations[i][0], rotations[i][1], rotations[i][2]});
    view_T_marker.translation() << translations[i][0], translations[i][1], translations[i][2];
    if (!view_T_marker.matrix().allFinite()) continue;
    const Eigen::Isometry3d camera_T_view =
        is_left ? Eigen::Isometry3d::Identity() : rig_.right_T_left.isometry().inverse();
    const auto pose = RigidTransform<Camera, Marker>::fromIsometry(camera_T_view * view_T_marker) *
                      coil_.markers[seen.marker].coil_T_marker.inverse();
    if (isSeenIn(other, !is_left, seen.marker, pose)) candidates.push_back({{seen.marker}, pose});
  }
  return candidates;
}

bool MarkerCoilTracker::isSeenIn(const cv::Mat& grey, bool is_left, std::size_t marker,
                                 const CoilToCamera& camera_T_coil) const {
  const auto quad = predictedCorners(marker, camera_T_coil, is_left);
  return quad && showsUpright(grey, *quad, patterns_[marker]);
}

void MarkerCoilTracker::addOtherMarkers(const stereo::StereoFrame& frame, Candidate& candidate) const {
  for (std::size_t marker = 0; marker < patterns_.size(); ++marker) {
    const auto& known = candidate.markers;
    if (std::find(known.begin(), known.end(), marker) != known.end()) continue;
    if (isSeenIn(frame.left, true, marker, candidate.start) &&
        isSeenIn(frame.right, false, marker, candidate.start))
      candidate.markers.push_back(marker);
  }
}

MarkerCoilTracker::Search MarkerCoilTracker::fitAll(const stereo::StereoFrame& frame,
                                                    const std::vector<Candidate>& candidates) const {
  Search result;
  for (Candidate candidate : candidates) {
    addOtherMarkers(frame, candidate);
    std::vector<SeenMarker> seen;
    for (const std::size_t marker : candidate.markers)
      seen.push_back(
          {&patterns_[marker], coil_.markers[marker].coil_T_marker, coil_.markers[marker].size_mm});
    result.has_candidate = true;
    const auto fit = fitMarkers(rig_, frame, seen, candidate.start);
    if (!fit || !isGood(*fit, candidate)) continue;
    // What was fitted must still read as the marker in both images.
    const std::size_t best = candidate.markers.front();
    if (!isSeenIn(frame.left, true, best, fit->camera_T_coil) ||
        !isSeenIn(frame.right, false, best, fit->camera_T_coil))
      continue;
    const bool is_known = std::any_of(result.good.begin(), result.good.end(), [&](const Solution& other) {
      return (other.fit.centre_mm - fit->centre_mm).norm() < 0.5 * coil_.markers[best].size_mm ||
             (other.fit.camera_T_coil.translation_mm() - fit->camera_T_coil.translation_mm()).norm() < 5.0;
    });
    if (!is_known) result.good.push_back({*fit, best});
  }
  return result;
}

bool MarkerCoilTracker::isGood(const MarkerFit& fit, const Candidate& candidate) const {
  const Eigen::Vector3d rotation_variance = fit.covariance.diagonal().head<3>();
  const Eigen::Vector3d translation_variance = fit.covariance.diagonal().tail<3>();
  const double side_px =
      rig_.left.k(0, 0) * coil_.markers[candidate.markers.front()].size_mm / fit.centre_mm.z();
  return fit.bias_px <= kMostBias_px && fit.rms_px <= kMostRms_px &&
         fit.inlier_fraction >= kLeastInlierFraction && std::abs(fit.size_factor - 1.0) <= kMostSizeError &&
         std::abs(fit.shrink_left_px) <= kMostShrink_px && std::abs(fit.shrink_right_px) <= kMostShrink_px &&
         fit.centre_mm.z() >= kLeastDepth_mm && side_px > 0 &&
         std::sqrt(rotation_variance.maxCoeff()) <= kMostRotationSigma_rad &&
         std::sqrt(translation_variance.maxCoeff()) <= kMostTranslationSigma_mm * fit.centre_mm.z() / 600.0;
}

Tracked<CoilPose> MarkerCoilTracker::accept(const Solution& solution, double t_s) {
  before_ = last_;
  last_ = Past{solution.fit.camera_T_coil, t_s};
  CoilPose pose;
  pose.camera_T_marker = solution.fit.camera_T_coil * coil_.markers.front().coil_T_marker;
  pose.covariance = solution.fit.covariance;
  pose.left_corners_px = *predictedCorners(solution.marker, solution.fit.camera_T_coil, true);
  pose.right_corners_px = *predictedCorners(solution.marker, solution.fit.camera_T_coil, false);
  const double fit_quality = 1.0 - solution.fit.bias_px / kMostBias_px;
  return {pose, std::clamp(fit_quality * solution.fit.inlier_fraction, 0.0, 1.0)};
}

}  // namespace

std::unique_ptr<CoilTracker> makeMarkerCoilTracker() { return std::make_unique<MarkerCoilTracker>(); }

}  // namespace facenav::tracking
