#include "track_verdict.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

namespace facenav::tracking {
namespace {

constexpr int kLeastGood = 15;            // patches in each camera
constexpr double kLeastGoodShare = 0.25;  // of the telling patches in view
constexpr double kWidestRatio = 3.5;      // between the cameras' shares
constexpr double kWorstSigma_mm = 0.8;    // of the face's centre
constexpr double kWorstSigma_rad = 0.7 * M_PI / 180;
constexpr double kWorstScale = 6.0;
constexpr double kCorrelation = 2.0;  // neighbouring patches err alike: variance is this much larger

struct Count {
  int telling = 0, good = 0;
  double share() const { return telling > 0 ? double(good) / telling : 0.0; }
};

Count count(const PoseFit& fit, int camera) {
  Count n;
  for (const auto& sight : fit.sights) {
    if (!sight[camera].is_visible || sight[camera].expected_ncc < 0.5f) continue;
    ++n.telling;
    n.good += sight[camera].isGood();
  }
  return n;
}

Matrix6d covarianceOf(const PoseFit& fit) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(fit.information);
  if (!(solver.eigenvalues()(0) > 1e-9)) return Matrix6d::Identity() * 1e6;
  Matrix6d rotate = Matrix6d::Zero();  // from Head's axes to Camera's
  rotate.topLeftCorner<3, 3>() = fit.motion.linear();
  rotate.bottomRightCorner<3, 3>() = fit.motion.linear();
  return kCorrelation * fit.scale * fit.scale * rotate * fit.information.inverse() * rotate.transpose();
}

}  // namespace

Verdict judge(const stereo::StereoRig&, const PatchModel& model, const PoseFit& fit) {
  Verdict verdict;
  const Count left = count(fit, 0), right = count(fit, 1);
  verdict.good_share = {left.share(), right.share()};
  verdict.covariance = model.shape_doubt * covarianceOf(fit);
  const double least = std::min(left.share(), right.share()), most = std::max(left.share(), right.share());
  if (std::max(left.good, right.good) < kLeastGood || most < kLeastGoodShare) {
    verdict.lost = LostReason::few_features;
  } else if (std::min(left.good, right.good) < kLeastGood || least < kLeastGoodShare ||
             most > kWidestRatio * least) {
    verdict.lost = LostReason::camera;
  } else if (fit.scale > kWorstScale ||
             verdict.covariance.bottomRightCorner<3, 3>().trace() >
                 model.shape_doubt * kWorstSigma_mm * kWorstSigma_mm ||
             verdict.covariance.topLeftCorner<3, 3>().trace() >
                 model.shape_doubt * kWorstSigma_rad * kWorstSigma_rad) {
    verdict.lost = LostReason::high_residual;
  }
  verdict.quality = std::clamp(least / 0.9, 0.0, 1.0);
  return verdict;
}

}  // namespace facenav::tracking
