#include "fit_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "cloud_sampling.h"
#include "facenav/core/error.h"
#include "skin_likelihood.h"

namespace facenav::registration {
namespace {

// Both must be exceeded: hair and a hand may cover more than half of what the cameras see, and then the third
// that fits best still tells; swollen skin lifts the best third, but not the median as far. Measured: right
// head 0.1-0.35 mm median and 0.6-0.9 close, wrong head 1.3-2.4 mm and 0.2-0.5 close.
constexpr double kWrongMedian_mm = 0.9, kWrongThird_mm = 0.5, kLeastClose = 0.3;
// Logarithms of odds. Measured: right heads +5 to +29, mirrored ones -5 to -55, a forehead alone -1.
constexpr double kMirrored = -5.0, kLeastUnmirrored = 1.0, kRival = 3.0;
constexpr double kHairy = 0.35;           // where hair is this frequent, it says nothing about the head
constexpr double kLeastExtent_mm = 45.0;  // a whole face has 120, forehead to mid-nose 80
constexpr double kLargestError_mm = 2.5;

std::string oneDecimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

Eigen::Isometry3d settle(const FieldFitter& fitter, Eigen::Isometry3d pose, float from_mm) {
  for (float reach_mm = from_mm; reach_mm > 1.2f; reach_mm *= 0.55f)
    pose = fitter.fit(pose, {reach_mm, 0.7f * reach_mm, 4, reach_mm < 4.0f});
  return fitter.fit(pose, {1.2f, 1.0f, 5, true});
}

/// Four standard deviations across or up the face, the smaller.
double facialExtent_mm(const std::vector<Eigen::Vector3f>& points_mri_mm) {
  if (points_mri_mm.empty()) return 0.0;
  Eigen::Array3d sum = Eigen::Array3d::Zero(), squares = sum;
  for (const auto& p : points_mri_mm)
    sum += p.cast<double>().array(), squares += p.cast<double>().array().square();
  const double n = double(points_mri_mm.size());
  const Eigen::Array3d extent = 4 * (squares / n - (sum / n).square()).max(0.0).sqrt();
  return std::min(extent.x(), extent.z());
}

/// How much likelier the skin is than its mirror image, fitted near the pose.
double mirrorLogOdds(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                     const Eigen::Isometry3d& mri_T_camera) {
  const Eigen::Vector3d middle = scalp.middle_mm();
  const SkinLikelihood logLikelihood(scalp, face, points);
  const FieldFitter mirrored(scalp, face, points, middle.x());
  double most = -1e9;
  for (const double yaw_deg : {-8.0, 0.0, 8.0}) {
    Vector6d turn = Vector6d::Zero();
    turn[2] = yaw_deg * M_PI / 180.0;
    const Eigen::Isometry3d pose = settle(mirrored, increment(turn, middle, mri_T_camera), 12.0f);
    most = std::max(most, logLikelihood(mirrored.match(pose)));
  }
  return logLikelihood(FieldFitter(scalp, face, points).match(mri_T_camera)) - most;
}

/// How much likelier the pose is than the best that the face finds elsewhere.
double rivalLogOdds(const ScalpField& scalp, const PointCloud<Camera>& face,
                    const Eigen::Isometry3d& mri_T_camera, const std::vector<Candidate>& rivals) {
  double most = -1e9;
  const std::vector<int> points = thinOut(face, 6.0, 2000);
  const FieldFitter everything(scalp, face, points);
  const SkinLikelihood logLikelihood(scalp, face, points);
  for (const Candidate& rival : rivals) {
    constexpr double kTruncated_mm2 = 16.0;  // a candidate's cost is a mean of squares cut at 4 mm
    if (kTruncated_mm2 - rival.cost < 0.6 * (kTruncated_mm2 - rivals.front().cost)) continue;
    const Eigen::Isometry3d pose = settle(everything, rival.mri_T_camera, 4.0f);
    if (!areDistinct(pose, mri_T_camera, scalp.middle_mm(), 6 * M_PI / 180.0, 10.0)) continue;
    most = std::max(most, logLikelihood(everything.match(pose)));
  }
  return logLikelihood(everything.match(mri_T_camera)) - most;
}

}  // namespace

FitEvidence gatherEvidence(const ScalpField& scalp, const PointCloud<Camera>& face,
                           const Eigen::Isometry3d& mri_T_camera, const std::vector<Candidate>& rivals) {
  FitEvidence evidence;
  const std::vector<int> near = nearHead(scalp, face, mri_T_camera, 30.0);
  const std::vector<int> head = thinOut(face, near, 3.0, 4000), sparse = thinOut(face, near, 5.0, 1500);
  const FaceRegions regions(scalp.noseTip_mm());
  std::size_t skin_points = 0;
  std::vector<double> core;
  std::vector<Eigen::Vector3f> close_mm;
  for (const PointMatch& m : FieldFitter(scalp, face, head).match(mri_T_camera)) {
    if (!m.is_valid || std::abs(m.residual_mm) > 15) continue;
    ++evidence.face_points;
    if (regions.foreignShare(m.at_mri_mm.cast<double>()) > kHairy) continue;
    ++skin_points;
    if (std::abs(m.residual_mm) < 1.5f) close_mm.push_back(m.at_mri_mm);
    if (std::abs(m.residual_mm) < 6) core.push_back(double(std::abs(m.residual_mm)));
  }
  evidence.close_fraction = double(close_mm.size()) / std::max<double>(1.0, double(skin_points));
  evidence.extent_mm = facialExtent_mm(close_mm);
  if (!core.empty()) {
    std::sort(core.begin(), core.end());
    evidence.best_third_mm = core[core.size() / 3];
    evidence.median_mm = core[core.size() / 2];
  }
  evidence.mirror_log_odds = mirrorLogOdds(scalp, face, sparse, mri_T_camera);
  if (rivals.size() > 1) evidence.rival_log_odds = rivalLogOdds(scalp, face, mri_T_camera, rivals);
  return evidence;
}

void requireTrust(const FitEvidence& evidence) {
  const auto refuse = [](const std::string& why, const std::string& remedy) {
    throw Error("not aligned: " + why, {}, remedy);
  };
  if (evidence.face_points < 300 || evidence.extent_mm < kLeastExtent_mm)
    refuse("too little of the face was measured", "show the whole face to both cameras, with the dots on it");
  if (evidence.mirror_log_odds < kMirrored)
    refuse("the MRI is mirrored: its left and right are swapped",
           "import the MRI again from its DICOM files");
  if ((evidence.median_mm > kWrongMedian_mm && evidence.best_third_mm > kWrongThird_mm) ||
      evidence.close_fraction < kLeastClose)
    refuse("the face does not fit this MRI (median distance " + oneDecimal(evidence.median_mm) + " mm)",
           "check that this is the patient's own MRI, and measure the face again");
  if (evidence.mirror_log_odds < kLeastUnmirrored)
    refuse("the face cannot be told from its mirror image",
           "check that the MRI's left and right are not swapped, and show more of the face to both cameras");
  if (evidence.rival_log_odds < kRival)
    refuse("the pose is ambiguous: the face fits in two places", "show more of the face to both cameras");
  if (!(evidence.predicted_error_mm < kLargestError_mm))
    refuse("too little of the face was measured to fix the pose (predicted error " +
               oneDecimal(evidence.predicted_error_mm) + " mm)",
           "show more of the face to both cameras");
}

}  // namespace facenav::registration
