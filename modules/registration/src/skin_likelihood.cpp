#include "skin_likelihood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "skin_patches.h"

namespace facenav::registration {
namespace {

constexpr double kPatch_mm = 25.0;
// Sizes that misfit may have, and their weights: log-normal about 0.35 mm, a factor of e^0.8 one sigma.
constexpr std::array<double, 4> kSigma_mm{0.2, 0.4, 0.8, 1.6}, kWeight{0.31, 0.39, 0.23, 0.07};
constexpr double kHair_mm = 8.0, kForeignFar_mm = 60.0;  // hair lies anywhere up to there; hands, coils
constexpr double kBehind = 0.15, kBehind_mm = 3.0;  // eyes, gross errors: nothing else lies behind the skin
constexpr double kNowhere_per_mm = 0.03;            // no counterpart: it says next to nothing
constexpr double kLeastOutside = 0.3;

double foreignDensity(double residual_mm) {
  if (residual_mm <= 0) return kBehind / kBehind_mm * std::exp(residual_mm / kBehind_mm);
  constexpr double kArea = 0.9064;  // of exp(-x^4) from 0 on
  return 0.65 / (kArea * kHair_mm) * std::exp(-std::pow(residual_mm / kHair_mm, 4)) +
         0.2 / kForeignFar_mm * std::exp(-residual_mm / kForeignFar_mm);
}

double skinDensity(double residual_mm, double sigma_mm) {
  const double u = residual_mm / sigma_mm;
  return std::exp(-0.5 * u * u) / (sigma_mm * std::sqrt(2 * M_PI));
}

}  // namespace

SkinLikelihood::SkinLikelihood(const ScalpField& scalp, const PointCloud<Camera>& face,
                               const std::vector<int>& points)
    : regions_(scalp.noseTip_mm()) {
  std::unordered_map<long long, int> counts;
  const auto patchOf = [&](int p) { return cubeOf(face.points_mm[std::size_t(p)].cast<float>(), kPatch_mm); };
  for (const int p : points) ++counts[patchOf(p)];
  std::vector<double> sizes;
  for (const auto& patch : counts) sizes.push_back(patch.second);
  const double full = median(sizes);
  for (const int p : points) weights_.push_back(float(1.0 / std::max<double>(full, counts[patchOf(p)])));
}

double SkinLikelihood::operator()(const std::vector<PointMatch>& matches) const {
  std::array<double, kSigma_mm.size()> sums{};
  for (std::size_t p = 0; p < matches.size(); ++p) {
    const PointMatch& match = matches[p];
    const double residual_mm = double(match.residual_mm);
    const double foreign = regions_.foreignShare(match.at_mri_mm.cast<double>());
    if (!match.is_valid) continue;
    // A hand or a coil before the face is rare, but no reason to look for the head elsewhere.
    const double other = std::max(foreign * foreignDensity(residual_mm),
                                  residual_mm > 0 ? kLeastOutside * kNowhere_per_mm : 0.0);
    // One head of hair is one thing: where it is likely, points say less than their number.
    const double weight = double(weights_[p]) * (1 - foreign);
    for (std::size_t s = 0; s < sums.size(); ++s)
      sums[s] += weight *
                 std::log(((1 - foreign) * skinDensity(residual_mm, kSigma_mm[s]) + other) / kNowhere_per_mm);
  }
  const double best = *std::max_element(sums.begin(), sums.end());
  double total = 0;
  for (std::size_t s = 0; s < sums.size(); ++s) total += kWeight[s] * std::exp(sums[s] - best);
  return best + std::log(total);
}

}  // namespace facenav::registration
