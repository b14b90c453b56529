#pragma once
// LossWords: the probable cause of a loss, for messages (loss_detail.h). It does not affect the pose.

#include <optional>

#include "facenav/core/tracked.h"
#include "facenav/head_tracking/loss_detail.h"
#include "head_motion.h"
#include "image_pyramid.h"

namespace facenav::head_tracking {

class LossWords {
 public:
  LossWords() = default;
  /// `face`: its box in the left reference image; `noise_grey`: of the images.
  LossWords(const Eigen::Vector3d& centre_mm, double noise_grey, const ImagePyramid& reference,
            const cv::Rect& face);

  /// The detail for a reason. If some patches look as expected, but too few: occluded.
  static LossDetail of(LostReason reason);
  /// Conditions that make any face hard to see: distance and blur. `left`: the left image; `face`: the face's
  /// box in it.
  std::optional<LossDetail> circumstance(const Eigen::Isometry3d& pose, const ImagePyramid& left,
                                         const cv::Rect& face, const HeadMotion& last,
                                         Timestamp captured) const;
  /// True if the head may be too far away. A head that was near a moment ago is not: such a fit has matched
  /// another object, such as a hand.
  bool isFar(const Eigen::Isometry3d& pose, const HeadMotion& last, Timestamp captured) const;

 private:
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  double noise_grey_ = 0.0, detail_at_start_ = 0.0;
};

}  // namespace facenav::head_tracking
