#pragma once
// LossWords: what a loss of the head looks like, in words for people (loss_detail.h). Decides nothing.

#include <optional>

#include "facenav/core/tracked.h"
#include "facenav/head_tracking/loss_detail.h"
#include "head_motion.h"
#include "image_pyramid.h"

namespace facenav::head_tracking {

class LossWords {
 public:
  LossWords() = default;
  /// `face`: its box in the left reference picture; `noise_grey`: of the pictures.
  LossWords(const Eigen::Vector3d& centre_mm, double noise_grey, const ImagePyramid& reference,
            const cv::Rect& face);

  /// Where patches look as they should, but too few, the rest is covered.
  static LossDetail of(LostReason reason);
  /// What makes any face hard to see, wherever it is: distance and blur. `left`: the left picture, `face`:
  /// where the face was in it.
  std::optional<LossDetail> circumstance(const Eigen::Isometry3d& pose, const ImagePyramid& left,
                                         const cv::Rect& face, const HeadMotion& last,
                                         Timestamp captured) const;
  /// Nobody is far off who was near a moment ago: a fit that says so has caught on something else, a hand.
  bool isFar(const Eigen::Isometry3d& pose, const HeadMotion& last, Timestamp captured) const;

 private:
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  double noise_grey_ = 0.0, detail_at_start_ = 0.0;
};

}  // namespace facenav::head_tracking
