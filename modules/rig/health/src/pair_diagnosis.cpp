#include "facenav/health/pair_diagnosis.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/health/pair_matches.h"
#include "facenav/health/rig_monitor.h"
#include "relative_pose.h"
#include "skin_evenness.h"

namespace facenav::health {
namespace {

constexpr std::size_t kFewestMatches = 25;
// Limits in standard errors of a match: of one match that agrees, and of the median.
constexpr double kAgrees = 3.3, kHolds = 1.7, kHoldsShare = 0.7;
constexpr double kExplainedCost = 3.8;  // cost per match: 1.9 for pure Student's t, twice that on skin
constexpr PosePrior kAnyRig{0.25, 60.0};
constexpr double kKnockDoubt = 25.0;  // decrease of cost: above this it is not a knock
constexpr std::size_t kFewestOnSkin = 150;
// Limit of the residual common to neighbouring skin, in standard errors of a match: above it the pictures are
// of two moments. A lower limit rejects more right pairs. Evidence: resources/doc/evidence.md.
constexpr double kTwoMoments = 2.0, kFarthest = 10.0;

double sigmaOf_px(const Correspondence& match) { return std::max(kMatchSigma_px, match.sigma_px); }

/// Median standard error of the matches, px.
double typicalSigma_px(const std::vector<Correspondence>& matches) {
  std::vector<double> sigmas_px;
  for (const auto& match : matches) sigmas_px.push_back(sigmaOf_px(match));
  return upperMedian(std::move(sigmas_px));
}

std::vector<RayPair> raysOf(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches,
                            bool is_swapped) {
  const double f_px = 0.5 * (rig.left.k(1, 1) + rig.right.k(1, 1));
  std::vector<RayPair> rays;
  for (const auto& match : matches)
    rays.push_back({cameras::undistort(rig.left, is_swapped ? match.right_px : match.left_px),
                    cameras::undistort(rig.right, is_swapped ? match.left_px : match.right_px),
                    sigmaOf_px(match) / f_px});
  return rays;
}

/// Median distance from the epipolar lines in standard errors, and share of the matches within kAgrees.
struct Fit {
  double median = 0, share = 0;
};

Fit fitOf(const Eigen::Isometry3d& pose, const std::vector<RayPair>& rays) {
  std::vector<double> off;
  for (const auto& pair : rays) off.push_back(epipolarDistance(pose, pair));
  std::sort(off.begin(), off.end());
  const auto within = std::lower_bound(off.begin(), off.end(), kAgrees) - off.begin();
  return {off[off.size() / 2], double(within) / double(off.size())};
}

/// The matches in that part of the left picture; all, if it is empty.
std::vector<Correspondence> within(const std::optional<cv::Rect>& part,
                                   const std::vector<Correspondence>& matches) {
  if (!part) return matches;
  std::vector<Correspondence> kept;
  for (const auto& match : matches)
    if (part->contains({int(match.left_px.x()), int(match.left_px.y())})) kept.push_back(match);
  return kept;
}

/// True if the errors of calibration and matching explain the matches as well as a moved camera does.
bool isWithinCalibration(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  RigMonitor monitor(rig);
  monitor.add(matches);
  return monitor.estimate().state == RigState::holds;
}

bool isExplained(const Fit& fit) { return fit.share > kHoldsShare && fit.median < kHolds; }

}  // namespace

PairDiagnosis diagnoseMatches(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  PairDiagnosis diagnosis;
  diagnosis.matches = matches.size();
  diagnosis.right_T_left = rig.right_T_left;
  if (matches.size() < kFewestMatches) return diagnosis;
  const Eigen::Isometry3d calibrated = rig.right_T_left.isometry();
  const auto rays = raysOf(rig, matches, false);
  const Fit as_is = fitOf(calibrated, rays);
  diagnosis.residual_px = as_is.median * typicalSigma_px(matches);
  diagnosis.agreement = diagnosis.calibrated_agreement = as_is.share;
  if (isExplained(as_is)) {
    diagnosis.state = RigState::holds;
    return diagnosis;
  }
  const Fit swapped = fitOf(calibrated, raysOf(rig, matches, true));
  if (swapped.median < kAgrees && swapped.share > as_is.share) {
    diagnosis.state = RigState::swapped;
    diagnosis.agreement = swapped.share;
    return diagnosis;
  }
  const RelativePose best = refinePose(calibrated, rays, &kAnyRig),
                     knocked = refinePose(calibrated, rays, &kKnock);
  const Fit explained = fitOf(best.right_T_left, rays);
  diagnosis.agreement = explained.share;
  diagnosis.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(best.right_T_left);
  const bool is_of_one_pose = isExplained(explained) && best.cost < kExplainedCost * double(rays.size());
  if (!is_of_one_pose)
    diagnosis.state = RigState::out_of_step;
  else
    diagnosis.state = knocked.cost - best.cost < kKnockDoubt ? RigState::moved : RigState::other_cameras;
  return diagnosis;
}

PairDiagnosis withSkin(const cameras::StereoRig& rig, PairDiagnosis diagnosis,
                       const std::vector<Correspondence>& skin) {
  if (!diagnosis.isOfCameras() || skin.size() < kFewestOnSkin) return diagnosis;
  const auto rays = raysOf(rig, skin, false);
  const RelativePose best = refinePose(diagnosis.right_T_left.isometry(), rays, &kAnyRig);
  std::vector<Eigen::Vector2d> left_px;
  for (const auto& match : skin) left_px.push_back(match.left_px);
  const double sigma_px = typicalSigma_px(skin);
  diagnosis.skin_px = sigma_px * sharedResidual(best.right_T_left, rays, left_px, kFarthest);
  if (diagnosis.skin_px > kTwoMoments * sigma_px) diagnosis.state = RigState::out_of_step;
  return diagnosis;
}

PairDiagnosis diagnosePair(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                           const std::optional<cv::Rect>& part) {
  if (frame.left.empty() || frame.right.empty()) return {};
  const auto all = matchPictures(frame.left, frame.right);
  auto matches = within(part, all);
  // Smooth skin has few corners. Its windows decide then.
  if (part && matches.size() < kFewestMatches)
    matches = within(part, growMatches(frame.left, frame.right, all));
  // A face on which nothing matches may be of two moments: then the rest of the pictures decides.
  const bool is_of_part = part && matches.size() >= kFewestMatches;
  if (matches.size() < kFewestMatches) matches = all;
  auto diagnosis = diagnoseMatches(rig, matches);
  diagnosis.is_of_part = is_of_part;
  if (!diagnosis.isOfCameras()) return diagnosis;
  diagnosis = withSkin(rig, diagnosis, growMatches(frame.left, frame.right, matches));
  // After the skin: pictures of two moments may differ by as little.
  if (diagnosis.state == RigState::moved && isWithinCalibration(rig, matches))
    diagnosis.state = RigState::holds;
  return diagnosis;
}

OffsetCause causeOfOffset(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                          const cv::Rect& face) {
  if (frame.left.empty() || frame.right.empty()) return OffsetCause::unknown;
  const auto all = matchPictures(frame.left, frame.right);
  const cv::Rect person(face.x - face.width, face.y - face.height, 3 * face.width, frame.left.rows);
  std::vector<Correspondence> on_face, in_room;
  for (const auto& match : all) {
    const cv::Point at(int(match.left_px.x()), int(match.left_px.y()));
    if (face.contains(at)) on_face.push_back(match);
    if (!person.contains(at)) in_room.push_back(match);
  }
  if (on_face.size() < kFewestMatches || in_room.size() < kFewestMatches) return OffsetCause::unknown;
  if (diagnoseMatches(rig, in_room).state == RigState::holds) return OffsetCause::two_exposures;
  const auto both = diagnoseMatches(rig, all);
  const Eigen::Isometry3d moved = both.right_T_left.isometry();
  const bool is_one_motion = both.isOfCameras() && isExplained(fitOf(moved, raysOf(rig, on_face, false))) &&
                             isExplained(fitOf(moved, raysOf(rig, in_room, false)));
  return is_one_motion ? OffsetCause::camera_moved : OffsetCause::unknown;
}

}  // namespace facenav::health
