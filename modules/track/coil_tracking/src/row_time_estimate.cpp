#include "row_time_estimate.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::coil_tracking {
namespace {

// Prior of the difference between the cameras' read-out times of a whole picture, standard deviation: two
// cameras of a pair are mostly of one kind. Their size itself may be anything, also if the rig states one:
// that may be of another mode of the sensor.
constexpr double kUnlike_s = 1.5e-3;
// A measured read-out time replaces the rig's if its standard deviation is below kCertain_s (lower is safe),
// and its difference from the rig's significant.
constexpr double kCertain_s = 3e-3;
// Factor on earlier frames in each new one. The first frames are fitted with a wrong row time, which
// falsifies the coil's speed a little, and with it their observations.
constexpr double kKept = 0.98;
// Share of a frame's information that is independent of its neighbours. Errors of lens, print, blur and coil
// speed are alike in neighbouring frames. Lower is safe.
constexpr double kIndependent = 0.1;

}  // namespace

void RowTimeEstimate::start(const cameras::StereoRig& rig) {
  rows_ = std::max(1, rig.height_px);
  stated_s_ = {rig.left.row_time_s, rig.right.row_time_s};
  const double common_s = cameras::kLongestReadout_s / rows_, unlike_s = kUnlike_s / rows_;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Constant(common_s * common_s);
  covariance.diagonal().array() += 0.5 * unlike_s * unlike_s;
  believed_ = covariance.inverse();
  seen_.setZero(), seen_right_.setZero();
}

void RowTimeEstimate::add(const RowTimeEquations& seen, const cameras::StereoRig& assumed) {
  if (!seen.information.allFinite() || !seen.right.allFinite()) return;
  const Eigen::Vector2d assumed_s(assumed.left.row_time_s, assumed.right.row_time_s);
  seen_ = kKept * seen_ + kIndependent * seen.information;
  seen_right_ = kKept * seen_right_ + kIndependent * (seen.information * assumed_s + seen.right);
}

void RowTimeEstimate::applyTo(cameras::StereoRig& rig) const {
  const Eigen::Matrix2d covariance = (believed_ + seen_).inverse();
  const Eigen::Vector2d mean = covariance * (believed_ * stated_s_ + seen_right_);
  const Eigen::Vector2d sigma_s = covariance.diagonal().cwiseSqrt(), off_s = (mean - stated_s_).cwiseAbs();
  const bool is_certain = sigma_s.maxCoeff() * rows_ < kCertain_s &&
                          mean.cwiseAbs().maxCoeff() * rows_ <= cameras::kLongestReadout_s &&
                          (off_s - kSignificant * sigma_s).maxCoeff() > 0.0;
  // Both at once: with different row times in the two cameras the same rows lie apart, which looks like
  // depth.
  const Eigen::Vector2d& used_s = is_certain ? mean : stated_s_;
  rig.left.row_time_s = used_s[0], rig.right.row_time_s = used_s[1];
}

}  // namespace facenav::coil_tracking
