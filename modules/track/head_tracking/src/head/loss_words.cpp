#include "loss_words.h"

#include <algorithm>

#include "fine_detail.h"

namespace facenav::head_tracking {
namespace {

constexpr double kFar = 1.6, kBlurred = 0.6;  // relative to the reference's distance and fine detail
constexpr double kNearlyFar = 1.25;

}  // namespace

LossWords::LossWords(const Eigen::Vector3d& centre_mm, double noise_grey, const ImagePyramid& reference,
                     const cv::Rect& face)
    : centre_mm_(centre_mm),
      noise_grey_(noise_grey),
      detail_at_start_(fineDetail(reference, face, noise_grey).value_or(0.0)) {}

LossDetail LossWords::of(LostReason reason) {
  switch (reason) {
    case LostReason::camera:
      return LossDetail::one_camera;
    case LostReason::few_features:
      return LossDetail::covered;
    default:
      return LossDetail::doubtful;
  }
}

std::optional<LossDetail> LossWords::circumstance(const Eigen::Isometry3d& pose, const ImagePyramid& left,
                                                  const cv::Rect& face, const HeadMotion& last,
                                                  Timestamp captured) const {
  if (isFar(pose, last, captured)) return LossDetail::too_far;
  const double detail = fineDetail(left, face, noise_grey_).value_or(detail_at_start_);
  if (detail < kBlurred * detail_at_start_) return LossDetail::blurred;
  return std::nullopt;
}

bool LossWords::isFar(const Eigen::Isometry3d& pose, const HeadMotion& last, Timestamp captured) const {
  const auto distanceAt = [&](const Eigen::Isometry3d& at) { return (at * centre_mm_).z(); };
  const double far_mm = kFar * centre_mm_.z();
  const double walked_mm = kWalk_mm_s * std::max(0.0, captured - last.captured());
  const bool may_be_far = !last.isKnown() || kNearlyFar * distanceAt(last.pose()) + walked_mm > far_mm;
  return may_be_far && distanceAt(pose) > far_mm;
}

}  // namespace facenav::head_tracking
