#include "fit_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "cloud/cloud_sampling.h"
#include "cloud/skin_patches.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/geometry/rotation.h"
#include "facenav/registration/fit_limits.h"
#include "fit/part_fits.h"
#include "fit/skin_likelihood.h"

namespace facenav::registration {
namespace {

constexpr double kNear_mm = 6.0;           // counts for the extent of the measured face
constexpr double kWholeFace = 0.8;         // share of bare skin of a face that nothing covers
constexpr double kFarFromMirrored = 30.0;  // log odds beyond which no closer comparison is needed

Eigen::Isometry3d settle(const FieldFitter& fitter, Eigen::Isometry3d pose, float from_mm, double noise_mm) {
  constexpr float kSettled_mm = 0.02f;
  const float least_mm = std::max(1.2f, kNoiseReach * float(noise_mm));
  for (float reach_mm = from_mm; reach_mm > least_mm; reach_mm *= 0.55f)
    pose = fitter.fit(pose, {reach_mm, 0.7f * reach_mm, 4, reach_mm < 4.0f, kSettled_mm});
  return fitter.fit(pose, {least_mm, least_mm / 1.2f, 5, true, kSettled_mm});
}

/// Four standard deviations across or up the face, whichever is smaller.
double facialExtent_mm(const std::vector<Eigen::Vector3f>& points_mri_mm) {
  if (points_mri_mm.empty()) return 0.0;
  Eigen::Array3d sum = Eigen::Array3d::Zero(), squares = sum;
  for (const auto& p : points_mri_mm)
    sum += p.cast<double>().array(), squares += p.cast<double>().array().square();
  const double n = double(points_mri_mm.size());
  const Eigen::Array3d extent = 4 * (squares / n - (sum / n).square()).max(0.0).sqrt();
  return std::min(extent.x(), extent.z());
}

Closeness closenessOf(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                      const Eigen::Isometry3d& mri_T_camera, const Covers& covers) {
  const FitLimits& limits = settingsOf<FitLimits>();
  const anatomy::FaceRegions regions(scalp.noseTip_mm());
  Closeness out;
  std::vector<double> bare;
  double skin = 0;
  std::vector<Eigen::Vector3f> near_mm;
  const auto matches = FieldFitter(scalp, face, points).match(mri_T_camera);
  for (std::size_t p = 0; p < matches.size(); ++p) {
    const PointMatch& m = matches[p];
    const double off_mm = double(std::abs(m.residual_mm));
    if (!m.is_valid || off_mm > 15) continue;
    ++out.face_points;
    if (regions.foreignShare(m.at_mri_mm.cast<double>()) > limits.hairy) continue;
    ++skin;
    if (off_mm < kNear_mm) near_mm.push_back(m.at_mri_mm);
    if (!covers.hold(face.points_mm[std::size_t(points[p])])) bare.push_back(off_mm);
  }
  out.bare_share = double(bare.size()) / std::max(1.0, skin);
  out.bare_mm = upperMedian(bare);
  out.extent_mm = facialExtent_mm(near_mm);
  return out;
}

/// Log likelihood ratio of the skin to its mirror image. The face is mirrored instead of the skin, which is
/// equivalent, and fitted as carefully as the face itself, from three turns near the pose.
void compareMirrored(FitEvidence& evidence, const ScalpField& scalp, const PointCloud<Camera>& face,
                     const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera, double noise_mm) {
  const auto flipped = [](Eigen::Vector3d v) { return Eigen::Vector3d(-v.x(), v.y(), v.z()); };
  PointCloud<Camera> mirrored = pick(face, points);
  for (auto& p : mirrored.points_mm) p = flipped(p);
  for (auto& n : mirrored.normals) n = flipped(n);
  std::vector<int> all(mirrored.size());
  std::iota(all.begin(), all.end(), 0);
  const Eigen::Vector3d middle = scalp.middle_mm();
  const Eigen::Vector3d flip(-1, 1, 1);
  Eigen::Isometry3d twin = Eigen::Isometry3d::Identity();
  twin.linear() = flip.asDiagonal() * mri_T_camera.linear() * flip.asDiagonal();
  twin.translation() = flipped(mri_T_camera.translation()) + Eigen::Vector3d(2 * middle.x(), 0, 0);
  const FieldFitter fitter(scalp, mirrored, all);
  const SkinLikelihood logLikelihood(scalp, mirrored, all, noise_mm);
  double most = -1e9;
  Eigen::Isometry3d best = twin;
  for (const double yaw_deg : {-8.0, 0.0, 8.0}) {
    Vector6d turn = Vector6d::Zero();
    turn[2] = yaw_deg * kRadPerDeg;
    const Eigen::Isometry3d pose = settle(fitter, increment(turn, middle, twin), 12.0f, noise_mm);
    const double there = logLikelihood(fitter.match(pose));
    if (there > most) most = there, best = pose;
  }
  const FieldFitter given(scalp, face, points);
  const double here = SkinLikelihood(scalp, face, points, noise_mm)(given.match(mri_T_camera));
  evidence.mirror_log_odds = here - most;
  if (evidence.mirror_log_odds > kFarFromMirrored) return;  // a closer fit cannot gain that much
  const PartFit closest = fitParts(scalp, mirrored, all, best, noise_mm).front();
  if (closest.log_likelihood > most) most = closest.log_likelihood, best = closest.mri_T_camera;
  evidence.mirror_log_odds = here - most;
  if (evidence.mirror_log_odds > 0) return;
  const auto by_person = logLikelihood.byPerson(fitter.match(best));
  evidence.does_mirror_fit = by_person.own - by_person.other > settingsOf<FitLimits>().least_own;
}

/// Log likelihood ratio of the pose to the best other pose.
double rivalLogOdds(const ScalpField& scalp, const PointCloud<Camera>& face,
                    const Eigen::Isometry3d& mri_T_camera, const std::vector<Candidate>& rivals,
                    double noise_mm) {
  double most = -1e9;
  const std::vector<int> points = thinOut(face, 6.0, 2000);
  const FieldFitter everything(scalp, face, points);
  const SkinLikelihood logLikelihood(scalp, face, points, noise_mm);
  for (const Candidate& rival : rivals) {
    constexpr double kTruncated_mm2 = 16.0;  // a candidate's cost is a mean of squares, each cut at 4 mm
    if (kTruncated_mm2 - rival.cost < 0.6 * (kTruncated_mm2 - rivals.front().cost)) continue;
    const Eigen::Isometry3d pose = settle(everything, rival.mri_T_camera, 4.0f, noise_mm);
    if (!areDistinct(pose, mri_T_camera, scalp.middle_mm(), 6 * kRadPerDeg, 10.0)) continue;
    most = std::max(most, logLikelihood(everything.match(pose)));
  }
  return logLikelihood(everything.match(mri_T_camera)) - most;
}

/// True if neither scan nor calibration explains the size: beyond some standard errors of both and of the
/// fit.
bool isRareSize(double scale, double sigma) {
  const FitLimits& limits = settingsOf<FitLimits>();
  return std::abs(scale - 1.0) > limits.refused_scale_z * std::hypot(sigma, limits.scanner_scale);
}

constexpr double kOtherSize = 0.05;  // standard deviation of other persons' faces from this one, in size
constexpr double kClearly = 20.0;    // log likelihood that chance hardly adds at another size

/// Log odds that this person's face is measured at that size, rather than another person's. A rare size has
/// the odds of the largest one that is not: it is refused for its size, in words.
double sizeLogOdds(double scale) {
  const FitLimits& limits = settingsOf<FitLimits>();
  const double own = limits.scanner_scale,
               off = std::min(std::abs(scale - 1.0), limits.refused_scale_z * own);
  return std::log(kOtherSize / own) - 0.5 * std::pow(off / own, 2) + 0.5 * std::pow(off / kOtherSize, 2);
}

/// Sizes of the live face relative to the scan that are tried.
constexpr double kSizes[] = {0.88, 0.91, 0.94, 0.96, 0.975, 0.985, 1.015, 1.025, 1.04, 1.06, 1.09, 1.12};

/// Finds the size at which the face is likeliest that of the scan's person. A scale error of scan or
/// calibration makes this person's face fit at another size; another person's fits at none. Rare sizes are
/// tried only where the face does not fit at the others.
void compareSizes(FitEvidence& evidence, const ScalpField& scalp, const PointCloud<Camera>& face,
                  const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera, double noise_mm) {
  const SkinLikelihood likelihood(scalp, face, points, noise_mm);
  const auto as_is = likelihood.byPerson(FieldFitter(scalp, face, points).match(mri_T_camera));
  evidence.own_log_odds = as_is.own - as_is.other + sizeLogOdds(1.0);
  const bool is_own = evidence.own_log_odds > settingsOf<FitLimits>().least_own;
  double most = as_is.own + kClearly;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int p : points) centre += face.points_mm[std::size_t(p)] / double(points.size());
  PointCloud<Camera> scaled = face;
  for (const double scale : kSizes) {
    const bool is_rare = isRareSize(scale, 0.0);
    if (is_rare && is_own) continue;
    for (const int p : points) scaled.points_mm[std::size_t(p)] = face.points_mm[std::size_t(p)] / scale;
    const FieldFitter fitter(scalp, scaled, points);
    const Eigen::Isometry3d start = mri_T_camera * Eigen::Translation3d(centre - centre / scale);
    const auto here = likelihood.byPerson(fitter.match(settle(fitter, start, 8.0f, noise_mm)));
    const double log_odds = here.own - here.other + sizeLogOdds(scale);
    // A coarsely measured face fits at many sizes: a rare one must be clearly likelier than its own.
    if ((is_own || is_rare) && here.own < most) continue;
    if (!is_own && log_odds < evidence.own_log_odds) continue;
    most = std::max(most, here.own);
    evidence.fitting_scale = scale;
    evidence.own_log_odds = log_odds;
  }
}

/// Standard deviation of the scale of usual scans.
double usualScale() {
  double squares = 0, shares = 0;
  for (const auto& [scale, share] : settingsOf<MisfitPrior>().scales)
    squares += share * scale * scale, shares += share;
  return std::sqrt(squares / shares);
}

std::string percent(double share) { return std::to_string(int(std::lround(100 * share))) + " %"; }

std::string percentOf(double scale) { return fixed(100.0 * scale, 1) + " %"; }

[[noreturn]] void refuse(const std::string& why, const std::string& remedy) {
  throw Error("not aligned: " + why, {}, remedy);
}

[[noreturn]] void refuseSize(double scale) {
  refuse(
      "the face does not fit this MRI: the cameras measure it at " + percentOf(scale) + " of its size there",
      "check that this is the patient's own MRI; if it is, the square size that the cameras were calibrated "
      "with");
}

[[noreturn]] void refuseAsTooLittle(const std::string& why, const std::string& remedy) {
  throw NotEnoughFace("not aligned: " + why, {}, remedy);
}

[[noreturn]] void refuseAsMirrored(const std::string& why, const std::string& remedy) {
  throw Mirrored("not aligned: " + why, {}, remedy);
}

[[noreturn]] void refuseAsEitherWay(const std::string& why, const std::string& remedy,
                                    double mirror_log_odds) {
  throw MayBeMirrored("not aligned: " + why, remedy, mirror_log_odds);
}

/// Least log odds against the mirror image of a face that alone tells the person. They stand for other
/// persons too: coarsely measured strangers fit both nearly as well. Where much counts as covered, the fit
/// could choose the parts that lie on the skin, and strangers fit there by chance.
double leastUnmirrored(double bare_share) {
  const FitLimits& limits = settingsOf<FitLimits>();
  return limits.least_unmirrored + limits.chosen_parts * std::max(0.0, kWholeFace - bare_share);
}

/// True if the face alone tells that the scan is this person's.
bool isPersonTold(const FitEvidence& evidence) {
  return evidence.own_log_odds > settingsOf<FitLimits>().least_own &&
         evidence.mirror_log_odds >= leastUnmirrored(evidence.closeness.bare_share);
}

std::string measuredAs(const Closeness& closeness) {
  return " (" + percent(closeness.bare_share) + " of it lies on the skin, by " + fixed(closeness.bare_mm, 1) +
         " mm)";
}

/// Refuses a face that does not fit, or one that was measured so coarsely that other heads fit as well.
[[noreturn]] void refuseAsAnother(const FitEvidence& evidence) {
  const std::string measured = measuredAs(evidence.closeness);
  if (evidence.own_log_odds < -settingsOf<FitLimits>().least_own)
    throw NotThisPerson("not aligned: the face does not fit this MRI" + measured,
                        "check that this is the patient's own MRI, and measure the face again",
                        evidence.own_log_odds);
  throw NotThisPerson(
      "not aligned: the face does not fit this MRI, or was measured too coarsely to tell" + measured,
      "check that this is the patient's own MRI; if it is, bring the cameras nearer, project dots, and keep "
      "hair and hands off the face",
      evidence.own_log_odds);
}

[[noreturn]] void refuseAsUnclear(const FitEvidence& evidence) {
  throw PersonUnclear(
      "not aligned: the face fits this MRI, but was measured too coarsely to tell this person from others" +
          measuredAs(evidence.closeness),
      "bring the cameras nearer, project dots, and keep hair and hands off the face; or check name and date "
      "of birth, and confirm that this is the patient's own MRI",
      evidence.own_log_odds);
}

[[noreturn]] void refuseTurn(const CameraTurn& turn) {
  throw CameraTurned(
      "not aligned: the face fits this MRI only if a camera has turned sideways since the calibration (by " +
          fixed(kDegPerRad * std::abs(turn.rad), 2) + " +/- " + fixed(kDegPerRad * turn.sigma_rad, 2) +
          " deg)",
      {},
      "fix the cameras and calibrate them again; if they never moved, check that this is the patient's own "
      "MRI, "
      "and its size");
}

}  // namespace

FitEvidence gatherEvidence(const ScalpField& scalp, const PointCloud<Camera>& face,
                           const Eigen::Isometry3d& mri_T_camera, const Covers& covers,
                           const std::vector<Candidate>& rivals, double noise_mm) {
  FitEvidence evidence;
  const std::vector<int> near = nearHead(scalp, face, finitePoints(face), mri_T_camera, 30.0);
  const std::vector<int> head = thinOut(face, near, 3.0, 4000), sparse = thinOut(face, near, 5.0, 1500);
  evidence.closeness = closenessOf(scalp, face, head, mri_T_camera, covers);
  compareMirrored(evidence, scalp, face, sparse, mri_T_camera, noise_mm);
  compareSizes(evidence, scalp, face, sparse, mri_T_camera, noise_mm);
  if (rivals.size() > 1) evidence.rival_log_odds = rivalLogOdds(scalp, face, mri_T_camera, rivals, noise_mm);
  return evidence;
}

void requireLikeness(const FitEvidence& evidence) {
  const FitLimits& limits = settingsOf<FitLimits>();
  const Closeness& closeness = evidence.closeness;
  if (closeness.face_points < 300 || closeness.extent_mm < limits.least_extent_mm)
    refuseAsTooLittle("too little of the face was measured",
                      "show the whole face to both cameras, with the dots on it");
  const bool is_own = evidence.own_log_odds > limits.least_own;
  // A symmetric face, measured coarsely, may fit both ways. Mirrored is one that does not fit as it is.
  if (evidence.mirror_log_odds < limits.mirrored && evidence.does_mirror_fit && !is_own)
    refuseAsMirrored("the MRI is mirrored: its left and right are swapped",
                     "import the MRI again from its DICOM files");
  if (evidence.own_log_odds < 0 || (!is_own && evidence.mirror_log_odds < limits.least_own))
    refuseAsAnother(evidence);
  if (is_own && isRareSize(evidence.fitting_scale, 0.0)) refuseSize(evidence.fitting_scale);
  // Nobody can see whether a scan is mirrored, so a confirmation does not replace these odds.
  if (evidence.mirror_log_odds < limits.least_own)
    refuseAsEitherWay("the face cannot be distinguished from its mirror image",
                      "bring the cameras nearer, project dots, and show more of the face to both cameras; "
                      "check that this is the patient's own MRI, its left and right not swapped",
                      evidence.mirror_log_odds);
  if (evidence.rival_log_odds < limits.rival)
    refuseAsTooLittle("the pose is ambiguous: the face fits in two places",
                      "show more of the face to both cameras");
  if (!evidence.is_patient_confirmed && !isPersonTold(evidence)) refuseAsUnclear(evidence);
}

bool restsOnConfirmation(const FitEvidence& evidence) {
  return evidence.is_patient_confirmed && !isPersonTold(evidence);
}

void requireTrust(const FitEvidence& evidence) {
  const FitLimits& limits = settingsOf<FitLimits>();
  requireLikeness(evidence);
  if (evidence.turn && std::abs(evidence.turn->rad) >
                           limits.refused_turn_z * std::hypot(evidence.turn->sigma_rad, evidence.scanner_rad))
    refuseTurn(*evidence.turn);
  if (evidence.scale_sigma > 0 && isRareSize(evidence.scale, evidence.scale_sigma))
    refuseSize(evidence.scale);
  if (!std::isfinite(evidence.predicted_error_mm))
    refuseAsTooLittle("too little of the face was measured to fix the pose",
                      "show more of the face to both cameras");
}

bool isPartlyCovered(const FitEvidence& evidence) {
  return evidence.closeness.bare_share < settingsOf<FitLimits>().mostly_bare;
}

std::vector<std::string> cautionsOf(const FitEvidence& evidence) {
  const FitLimits& limits = settingsOf<FitLimits>();
  std::vector<std::string> cautions;
  const double unusual = std::abs(evidence.scale - 1) / std::hypot(evidence.scale_sigma, usualScale());
  if (evidence.scale_sigma > 0 && unusual > limits.caution_scale_z)
    cautions.push_back("the cameras measure the face at " + percentOf(evidence.scale) +
                       " of the MRI's size (+/- " + fixed(100 * evidence.scale_sigma, 1) +
                       "): check the square size that they were calibrated with, and the MRI's size");
  if (evidence.predicted_error_mm > limits.large_error_mm)
    cautions.push_back("the face fixes the pose to " + fixed(evidence.predicted_error_mm, 1) +
                       " mm only: show more of the face to both cameras, and keep it calm");
  const double loose_mm = std::max(evidence.closeness.bare_mm, evidence.misfit_mm);
  if (loose_mm > limits.loose_mm)
    cautions.push_back("the skin fits loosely (by " + fixed(loose_mm, 1) +
                       " mm): check that this is the patient's own MRI, and a calm face");
  if (restsOnConfirmation(evidence))
    cautions.push_back(
        "the face was measured too coarsely to tell this person from others: a person confirmed "
        "that this is the patient's own MRI");
  if (isPartlyCovered(evidence))
    cautions.push_back(percent(1 - evidence.closeness.bare_share) +
                       " of the face is covered (a mask, hair, a hand): the rest was aligned");
  return cautions;
}

}  // namespace facenav::registration
