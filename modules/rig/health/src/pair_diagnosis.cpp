#include "facenav/health/pair_diagnosis.h"

#include <algorithm>
#include <cmath>

#include "facenav/health/pair_matches.h"
#include "relative_pose.h"
#include "skin_evenness.h"

namespace facenav::health {
namespace {

constexpr std::size_t kFewestMatches = 25;
// Standard error of one match on skin: texture, noise, slant of skin and compression.
constexpr double kMatchSigma_px = 0.3;
constexpr double kAgrees_px = 1.0;
// Limits between that error and the effect of the smallest motion that differs from noise: 1 px of parallax.
constexpr double kHolds_px = 0.5, kSwappedHolds_px = 1.0;
constexpr double kExplainedShare = 0.7, kExplained_px = 0.4;
constexpr double kExplainedCost = 3.8;  // cost per match: 1.9 for pure Student's t, twice that on skin
constexpr PosePrior kKnock{0.02, 3.0};  // as in RigMonitor
constexpr PosePrior kAnyRig{0.25, 60.0};
constexpr double kKnockDoubt = 25.0;  // decrease of cost: above this it is not a knock
constexpr std::size_t kFewestOnSkin = 150;
// Limit of the residual common to neighbouring skin, px: above it the pictures are of two moments. A lower
// limit rejects more right pairs. Evidence: resources/doc/evidence.md.
constexpr double kTwoMoments_px = 0.60, kFarthest_px = 3.0;

std::vector<RayPair> raysOf(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches,
                            bool is_swapped) {
  const double f_px = 0.5 * (rig.left.k(1, 1) + rig.right.k(1, 1));
  std::vector<RayPair> rays;
  for (const auto& match : matches)
    rays.push_back({cameras::undistort(rig.left, is_swapped ? match.right_px : match.left_px),
                    cameras::undistort(rig.right, is_swapped ? match.left_px : match.right_px),
                    kMatchSigma_px / f_px});
  return rays;
}

struct Fit {
  double median_px = 0,
         share = 0;  // median distance from the epipolar lines; share of matches within kAgrees_px
};

Fit fitOf(const Eigen::Isometry3d& pose, const std::vector<RayPair>& rays) {
  std::vector<double> off_px;
  for (const auto& pair : rays) off_px.push_back(kMatchSigma_px * epipolarDistance(pose, pair));
  std::sort(off_px.begin(), off_px.end());
  const auto within = std::lower_bound(off_px.begin(), off_px.end(), kAgrees_px) - off_px.begin();
  return {off_px[off_px.size() / 2], double(within) / double(off_px.size())};
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

bool isExplained(const Fit& fit) { return fit.share > kExplainedShare && fit.median_px < kExplained_px; }

}  // namespace

PairDiagnosis diagnoseMatches(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  PairDiagnosis diagnosis;
  diagnosis.matches = matches.size();
  diagnosis.right_T_left = rig.right_T_left;
  if (matches.size() < kFewestMatches) return diagnosis;
  const Eigen::Isometry3d calibrated = rig.right_T_left.isometry();
  const auto rays = raysOf(rig, matches, false);
  const Fit as_is = fitOf(calibrated, rays);
  diagnosis.residual_px = as_is.median_px;
  diagnosis.agreement = diagnosis.calibrated_agreement = as_is.share;
  if (as_is.median_px < kHolds_px && as_is.share > kExplainedShare) {
    diagnosis.state = RigState::holds;
    return diagnosis;
  }
  const Fit swapped = fitOf(calibrated, raysOf(rig, matches, true));
  if (swapped.median_px < kSwappedHolds_px && swapped.share > as_is.share) {
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
  diagnosis.skin_px =
      kMatchSigma_px * sharedResidual(best.right_T_left, rays, left_px, kFarthest_px / kMatchSigma_px);
  if (diagnosis.skin_px > kTwoMoments_px) diagnosis.state = RigState::out_of_step;
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
  if (matches.size() < kFewestMatches) matches = all;
  const auto diagnosis = diagnoseMatches(rig, matches);
  if (!diagnosis.isOfCameras()) return diagnosis;
  return withSkin(rig, diagnosis, growMatches(frame.left, frame.right, matches));
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
