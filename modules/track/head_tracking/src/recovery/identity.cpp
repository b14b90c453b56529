#include "identity.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/settings_in_force.h"
#include "facenav/head_tracking/identity_model.h"

namespace facenav::head_tracking {
namespace {

double logNormal(double x, double mean, double sigma) {
  return -0.5 * std::pow((x - mean) / sigma, 2) - std::log(sigma);
}

/// Standard deviation of the logit of a share: that over people, and that of a share of so few windows.
double sigmaOfLogit(double of_people, double mean_logit, double independent_windows) {
  const double mean = 1.0 / (1.0 + std::exp(-mean_logit));
  return std::hypot(of_people, 1.0 / std::sqrt(std::max(1.0, independent_windows) * mean * (1.0 - mean)));
}

}  // namespace

bool Identity::isAnswered() const { return windows > 0; }

double Identity::logOdds() const { return log_likelihood_ratio + settingsOf<IdentityModel>().identity_prior; }

Identity::Verdict Identity::verdict() const {
  if (!isAnswered()) return Verdict::undecided;
  const double sure = settingsOf<IdentityModel>().identity_sure;
  if (logOdds() > sure) return Verdict::patient;
  return logOdds() < -sure ? Verdict::other : Verdict::undecided;
}

Identity identityOf(const cameras::StereoRig& rig, const SkinPoints& points, const SkinView& then,
                    const RecoveryPose& pose) {
  const IdentityModel& model = settingsOf<IdentityModel>();
  Identity identity;
  const double tolerance_px =
      std::max(model.identity_least_in_place_px, model.identity_in_place * points.halfWindow_px());
  std::array<int, 2> windows = {0, 0}, in_place = {0, 0};
  for (int c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < points.size(); ++i)
      windows[std::size_t(c)] += points[i].mobility_mm <= model.identity_rigid_mm &&
                                 points.isSeen(i, c, then, rig, pose.camera_T_head);
  identity.windows = windows[0] + windows[1];
  if (!pose.is_valid || identity.windows == 0) return identity;
  for (std::size_t k = 0; k < pose.matches.size(); ++k)
    in_place[std::size_t(pose.matches[k].camera)] +=
        points[std::size_t(pose.matches[k].point)].mobility_mm <= model.identity_rigid_mm &&
        pose.residual_px[k] < tolerance_px;
  for (std::size_t c = 0; c < 2; ++c) identity.side_share[c] = double(in_place[c]) / std::max(1, windows[c]);
  identity.in_place_share = double(in_place[0] + in_place[1]) / identity.windows;
  const double logit = std::log((identity.in_place_share + 0.01) / (1.01 - identity.in_place_share));
  const double independent = points.independentShare() * identity.windows;
  const double own = model.identity_own_mean, other = model.identity_other_mean;
  // A share beyond the mean of its own distribution must not reduce the evidence for it.
  identity.log_likelihood_ratio =
      logNormal(std::min(logit, own), own, sigmaOfLogit(model.identity_own_sigma, own, independent)) -
      logNormal(std::max(logit, other), other, sigmaOfLogit(model.identity_other_sigma, other, independent));
  return identity;
}

}  // namespace facenav::head_tracking
