#include "identity.h"

#include <algorithm>
#include <cmath>

namespace facenav::head_tracking {
namespace {

constexpr double kRigid_mm = 0.6;  // mobility of skin that is asked
constexpr double kInPlace = 0.15;  // of half a window: residual of a window in its place
constexpr double kLeastInPlace_px = 1.0;
constexpr int kFewestWindows = 60;
// Logit of the share, mean and standard deviation. Fitted on: one real person, 60 attempts over five moments
// and three pairs of cameras (0.82, 0.65), against the same person mirrored, a face of the same size and
// nearly the same shape, 25 attempts (-2.7, 0.33; a program that is not kept). Widened for people and cameras
// that were not seen.
constexpr double kOwnMean = 0.8, kOwnSigma = 0.75, kOtherMean = -2.7, kOtherSigma = 0.6;
// Robust rms of the upper face's shape, mm: the logarithm's mean and standard deviation. Not fitted: 0.7 mm
// is what two pairs of cameras leave on one real face without dots, 1.6 mm what adult faces differ by.
constexpr double kOwnShape = -0.35, kOwnShapeSigma = 0.35, kOtherShape = 0.45, kOtherShapeSigma = 0.45;
constexpr double kSure = 4.6;  // 100 : 1

double logNormal(double x, double mean, double sigma) {
  return -0.5 * std::pow((x - mean) / sigma, 2) - std::log(sigma);
}

}  // namespace

bool Identity::isAnswered() const { return windows >= kFewestWindows; }

Identity::Verdict Identity::verdict() const {
  if (!isAnswered()) return Verdict::undecided;
  if (log_likelihood_ratio > kSure) return Verdict::patient;
  return log_likelihood_ratio < -kSure ? Verdict::other : Verdict::undecided;
}

Identity identityOf(const cameras::StereoRig& rig, const SkinPoints& points, const SkinView& then,
                    const RecoveryPose& pose, const std::optional<ShapeFit>& shape) {
  Identity identity;
  const double tolerance_px = std::max(kLeastInPlace_px, kInPlace * points.halfWindow_px());
  std::array<int, 2> windows = {0, 0}, in_place = {0, 0};
  for (int c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < points.size(); ++i)
      windows[std::size_t(c)] +=
          points[i].mobility_mm <= kRigid_mm && points.isSeen(i, c, then, rig, pose.camera_T_head);
  identity.windows = windows[0] + windows[1];
  if (!pose.is_valid || identity.windows == 0) return identity;
  for (std::size_t k = 0; k < pose.matches.size(); ++k)
    in_place[std::size_t(pose.matches[k].camera)] +=
        points[std::size_t(pose.matches[k].point)].mobility_mm <= kRigid_mm &&
        pose.residual_px[k] < tolerance_px;
  for (std::size_t c = 0; c < 2; ++c) identity.side_share[c] = double(in_place[c]) / std::max(1, windows[c]);
  identity.looks_share = double(in_place[0] + in_place[1]) / identity.windows;
  const double logit = std::log((identity.looks_share + 0.01) / (1.01 - identity.looks_share));
  // Beyond its own mean a share speaks no less for its side.
  identity.log_likelihood_ratio = logNormal(std::min(logit, kOwnMean), kOwnMean, kOwnSigma) -
                                  logNormal(std::max(logit, kOtherMean), kOtherMean, kOtherSigma);
  if (shape) {
    identity.shape_rms_mm = shape->rms_mm;
    const double log_rms = std::log(std::max(0.05, shape->rms_mm));
    identity.log_likelihood_ratio += logNormal(std::max(log_rms, kOwnShape), kOwnShape, kOwnShapeSigma) -
                                     logNormal(std::min(log_rms, kOtherShape), kOtherShape, kOtherShapeSigma);
  }
  return identity;
}

}  // namespace facenav::head_tracking
