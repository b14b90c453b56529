#include "facenav/health/pair_diagnosis.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/core/robust_statistics.h"
#include "facenav/health/pair_matches.h"
#include "facenav/health/rig_monitor.h"
#include "facenav/health/surface_matches.h"
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
constexpr double kDecided = 6.0;      // difference of cost: one cause is 20 times as likely as the other
constexpr double kFarBaselines = 10;  // a face in front of the cameras, in baselines
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

/// The matches inside the outline in the left picture; all, if it is empty.
std::vector<Correspondence> within(const std::vector<cv::Point>& outline,
                                   const std::vector<Correspondence>& matches) {
  std::vector<Correspondence> kept;
  for (const auto& match : matches)
    if (isInside(outline, match.left_px)) kept.push_back(match);
  return kept;
}

/// The matches beside the person. Hair and clothes move with the head, or by themselves.
std::vector<Correspondence> inRoom(const std::vector<cv::Point>& face_px,
                                   const std::vector<Correspondence>& matches) {
  const cv::Rect face = cv::boundingRect(face_px);
  std::vector<Correspondence> kept;
  for (const auto& match : matches)
    if (match.left_px.y() < face.y - face.height || match.left_px.x() < face.x - face.width ||
        match.left_px.x() > face.x + 2 * face.width)
      kept.push_back(match);
  return kept;
}

/// True if the errors of calibration and matching explain the matches as well as a moved camera does.
bool isWithinCalibration(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  RigMonitor monitor(rig);
  monitor.add(matches);
  return monitor.estimate().state == RigState::holds;
}

bool isExplained(const Fit& fit) { return fit.share > kHoldsShare && fit.median < kHolds; }

/// The calibration's pose of the right camera; or, if the matches lie behind the cameras with it, a pose that
/// sees their middle in front: from the calibration's pose no search reaches the one that fits.
Eigen::Isometry3d startOf(const Eigen::Isometry3d& calibrated, const std::vector<RayPair>& rays) {
  Eigen::Vector2d left(0, 0), right(0, 0);
  std::size_t behind = 0;
  for (const auto& pair : rays) {
    behind += std::isinf(epipolarDistance(calibrated, pair));
    left += pair.left / double(rays.size()), right += pair.right / double(rays.size());
  }
  if (2 * behind < rays.size()) return calibrated;
  const Eigen::Vector3d point = kFarBaselines * calibrated.translation().norm() * left.homogeneous();
  return Eigen::Isometry3d(Eigen::Quaterniond::FromTwoVectors(calibrated * point, right.homogeneous())) *
         calibrated;
}

/// The face matches nowhere: it may be of two moments. The rest of the pictures cannot tell more than that,
/// or that they are exchanged, since clothes and wallpaper match in wrong places.
PairDiagnosis withoutFace(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  PairDiagnosis diagnosis = diagnoseMatches(rig, matches);
  if (diagnosis.state != RigState::swapped && diagnosis.state != RigState::out_of_step)
    diagnosis.state = RigState::unclear;
  return diagnosis;
}

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
  const RelativePose best = refinePose(startOf(calibrated, rays), rays, &kAnyRig),
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

PairDiagnosis withRoom(const cameras::StereoRig& rig, PairDiagnosis diagnosis,
                       const std::vector<Correspondence>& face, const std::vector<Correspondence>& room) {
  if (!diagnosis.isOfCameras()) return diagnosis;
  const OffsetCause cause = likelierCause(rig, face, room);
  if (cause == OffsetCause::two_exposures)
    diagnosis.state = RigState::out_of_step;
  else if (cause == OffsetCause::unknown && diagnosis.state == RigState::moved)
    diagnosis.state = RigState::disagree;
  return diagnosis;
}

/// Both causes are one motion of the same size: of the right camera against face and room, or of the face
/// alone while the room fits the calibration. So their costs compare as they are.
OffsetCause likelierCause(const cameras::StereoRig& rig, const std::vector<Correspondence>& face,
                          const std::vector<Correspondence>& room) {
  if (face.size() < kFewestMatches || room.size() < kFewestMatches) return OffsetCause::unknown;
  const Eigen::Isometry3d calibrated = rig.right_T_left.isometry();
  const auto face_rays = raysOf(rig, face, false), room_rays = raysOf(rig, room, false);
  auto all_rays = face_rays;
  all_rays.insert(all_rays.end(), room_rays.begin(), room_rays.end());
  const RelativePose moved = refinePose(calibrated, all_rays, &kKnock);
  const double by_head = costOf(calibrated, room_rays) + refinePose(calibrated, face_rays, &kKnock).cost;
  if (moved.cost - by_head > kDecided) return OffsetCause::two_exposures;
  // Wallpaper matches one pattern off: a room that no motion explains is no evidence of one. Nor is a room
  // that is off its lines by the calibration's own error.
  const bool is_motion = by_head - moved.cost > kDecided &&
                         isExplained(fitOf(moved.right_T_left, room_rays)) && !isWithinCalibration(rig, room);
  return is_motion ? OffsetCause::camera_moved : OffsetCause::unknown;
}

PairDiagnosis diagnosePair(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                           const std::vector<cv::Point>& face_px) {
  if (frame.left.empty() || frame.right.empty()) return {};
  const auto all = matchPictures(frame.left, frame.right);
  auto matches = within(face_px, all);
  // Smooth skin has few corners. Its windows decide then.
  if (!face_px.empty() && matches.size() < kFewestMatches)
    matches = within(face_px, growMatches(frame.left, frame.right, all));
  if (!face_px.empty() && matches.size() < kFewestMatches) return withoutFace(rig, all);
  auto diagnosis = diagnoseMatches(rig, matches);
  diagnosis.is_of_face = !face_px.empty();
  if (diagnosis.isOfCameras()) {
    diagnosis = withSkin(rig, diagnosis, within(face_px, growMatches(frame.left, frame.right, matches)));
    // After the skin: pictures of two moments may differ by as little.
    if (diagnosis.state == RigState::moved && isWithinCalibration(rig, matches))
      diagnosis.state = RigState::holds;
  }
  return face_px.empty() ? diagnosis : withRoom(rig, diagnosis, matches, inRoom(face_px, all));
}

OffsetCause causeOfOffset(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                          const std::vector<cv::Point>& face_px) {
  if (frame.left.empty() || frame.right.empty() || face_px.empty()) return OffsetCause::unknown;
  const auto all = matchPictures(frame.left, frame.right);
  return likelierCause(rig, within(face_px, all), inRoom(face_px, all));
}

}  // namespace facenav::health
