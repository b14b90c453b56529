#include "facenav/evaluation/tracking_evaluation.h"

#include "facenav/evaluation/frame_errors.h"
#include "facenav/geometry/rotation.h"

namespace facenav::evaluation {
namespace {

FrameError errorOf(const PoseEstimate& estimate, const Eigen::Isometry3d& truth,
                   const Eigen::Vector3d& point_mm) {
  FrameError error;
  error.frame = estimate.frame;
  error.rotation_about_deg = kDegPerRad * logRotation(estimate.pose.linear() * truth.linear().transpose());
  error.rotation_deg = error.rotation_about_deg.norm();
  error.translation_mm = (estimate.pose.translation() - truth.translation()).norm();
  error.shift_mm = estimate.pose * point_mm - truth * point_mm;
  error.at_point_mm = error.shift_mm.norm();
  return error;
}

}  // namespace

TrackingEvaluation evaluateTracking(const std::vector<PoseEstimate>& estimates,
                                    const std::map<std::int64_t, Eigen::Isometry3d>& truth,
                                    const Eigen::Vector3d& point_mm) {
  TrackingEvaluation result;
  std::vector<double> rotation, translation, at_point;
  for (const PoseEstimate& estimate : estimates) {
    ++result.frames;
    if (!estimate.is_tracked) {
      ++result.lost;
      continue;
    }
    ++result.tracked;
    const auto found = truth.find(estimate.frame);
    if (found == truth.end()) continue;
    result.errors.push_back(errorOf(estimate, found->second, point_mm));
    const FrameError& error = result.errors.back();
    rotation.push_back(error.rotation_deg);
    translation.push_back(error.translation_mm);
    at_point.push_back(error.at_point_mm);
    result.wrong_as_tracked += error.at_point_mm > kWrong_mm || error.rotation_deg > kWrong_deg;
  }
  result.rotation_deg = summarise(rotation);
  result.translation_mm = summarise(translation);
  result.at_point_mm = summarise(at_point);
  return result;
}

}  // namespace facenav::evaluation
