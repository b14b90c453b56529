#include "fit_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "cloud_sampling.h"
#include "facenav/core/error.h"

namespace facenav::registration {
namespace {

constexpr double kSupport_mm = 1.2;
// Measured on two heads, clouds with 0.2 mm noise, hair, clothes and 0.3 mm of smooth misfit: right head
// 0.1-0.35 mm and 0.6-0.9 close, wrong head 1.3-2.4 mm and 0.2-0.5 close.
constexpr double kWrongHead_mm = 0.9, kLeastClose = 0.4;
constexpr double kMirrored = 1.1;  // support of the mirrored skin over that of the skin
constexpr double kRival = 0.9;
constexpr double kLeastExtent_mm = 45.0;  // a whole face has 120, forehead to mid-nose 80
constexpr double kLargestError_mm = 2.5;

std::string oneDecimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

double support(const PoseFitter& fitter, const Eigen::Isometry3d& mri_T_camera) {
  double sum = 0;
  for (const PointMatch& m : fitter.match(mri_T_camera, true)) {
    const double u = m.residual_mm / kSupport_mm;
    if (m.is_valid && std::abs(u) < 1) sum += 1 - u * u;
  }
  return sum;
}

Eigen::Isometry3d settle(const PoseFitter& fitter, Eigen::Isometry3d pose, double from_mm) {
  for (double reach_mm = from_mm; reach_mm > 1.0; reach_mm *= 0.6)
    pose = fitter.fit(pose, {reach_mm, 0.75 * reach_mm, 6, false});
  return fitter.fit(pose, {1.2, 1.0, 8, false});
}

/// Four standard deviations across or up the face, the smaller.
double facialExtent_mm(const std::vector<Eigen::Vector3d>& points_mri_mm) {
  if (points_mri_mm.empty()) return 0.0;
  Eigen::Array3d sum = Eigen::Array3d::Zero(), squares = sum;
  for (const auto& p : points_mri_mm) sum += p.array(), squares += p.array().square();
  const double n = double(points_mri_mm.size());
  const Eigen::Array3d extent = 4 * (squares / n - (sum / n).square()).max(0.0).sqrt();
  return std::min(extent.x(), extent.z());
}

/// The best support that the mirrored skin finds near the pose.
double mirroredSupport(const SkinField& skin, const PointCloud<Camera>& face,
                       const Eigen::Isometry3d& mri_T_camera) {
  const PoseFitter mirrored(skin, face, 0.5 * (skin.low().x() + skin.high().x()));
  double best = 0;
  for (const double yaw_deg : {-8.0, 0.0, 8.0}) {
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.linear() = Eigen::AngleAxisd(yaw_deg * M_PI / 180.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    turn.translation() = mirrored.pivot_mri_mm() - turn.linear() * mirrored.pivot_mri_mm();
    best = std::max(best, support(mirrored, settle(mirrored, turn * mri_T_camera, 12.0)));
  }
  return best;
}

}  // namespace

FitEvidence gatherEvidence(const SkinField& skin, const PointCloud<Camera>& face,
                           const Eigen::Isometry3d& mri_T_camera, const std::vector<Candidate>& rivals) {
  FitEvidence evidence;
  const PointCloud<Camera> head = pick(face, nearHead(skin, face, mri_T_camera, 30.0));
  const PoseFitter fitter(skin, pick(head, thinOut(head, 3.0, 4000)));
  std::vector<double> core;
  std::vector<Eigen::Vector3d> close_mm;
  for (const PointMatch& m : fitter.match(mri_T_camera, true)) {
    if (!m.is_valid || std::abs(m.residual_mm) > 15) continue;
    ++evidence.face_points;
    if (std::abs(m.residual_mm) < 1.5) close_mm.push_back(m.at_mri_mm);
    if (std::abs(m.residual_mm) < 6) core.push_back(std::abs(m.residual_mm));
  }
  evidence.close_fraction = double(close_mm.size()) / std::max<double>(1.0, double(evidence.face_points));
  evidence.extent_mm = facialExtent_mm(close_mm);
  if (!core.empty()) {
    std::nth_element(core.begin(), core.begin() + core.size() / 2, core.end());
    evidence.core_residual_mm = core[core.size() / 2];
  }
  evidence.support = support(fitter, mri_T_camera);
  evidence.mirrored_support = mirroredSupport(skin, fitter.cloud(), mri_T_camera);
  const PoseFitter everything(skin, pick(face, thinOut(face, 5.0, 4000)));
  for (const Candidate& rival : rivals) {
    const Eigen::Isometry3d pose = settle(everything, rival.mri_T_camera, 4.0);
    if (!areDistinct(pose, mri_T_camera, fitter.pivot_mri_mm(), 3 * M_PI / 180.0, 5.0)) continue;
    const PointCloud<Camera> elsewhere = pick(face, nearHead(skin, face, pose, 30.0));
    const PoseFitter rival_fitter(skin, pick(elsewhere, thinOut(elsewhere, 3.0, 4000)));
    evidence.rival_support =
        std::max(evidence.rival_support, support(rival_fitter, settle(rival_fitter, pose, 2.0)));
  }
  return evidence;
}

void requireTrust(const FitEvidence& evidence) {
  const auto refuse = [](const std::string& why, const std::string& remedy) {
    throw Error("not aligned: " + why, {}, remedy);
  };
  if (evidence.face_points < 300 || evidence.extent_mm < kLeastExtent_mm)
    refuse("too little of the face was measured", "show the whole face to both cameras, with the dots on it");
  if (evidence.mirrored_support > kMirrored * evidence.support &&
      evidence.mirrored_support > 0.5 * double(evidence.face_points))
    refuse("the MRI is mirrored: its left and right are swapped",
           "import the MRI again from its DICOM files");
  if (evidence.core_residual_mm > kWrongHead_mm || evidence.close_fraction < kLeastClose)
    refuse(
        "the face does not fit this MRI (median distance " + oneDecimal(evidence.core_residual_mm) + " mm)",
        "check that this is the patient's own MRI, and measure the face again");
  if (evidence.rival_support > kRival * evidence.support)
    refuse("the pose is ambiguous: the face fits in two places", "show more of the face to both cameras");
  if (!(evidence.predicted_error_mm < kLargestError_mm))
    refuse("too little of the face was measured to fix the pose (predicted error " +
               oneDecimal(evidence.predicted_error_mm) + " mm)",
           "show more of the face to both cameras");
}

}  // namespace facenav::registration
