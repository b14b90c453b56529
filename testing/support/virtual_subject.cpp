#include "support/virtual_subject.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

#include "normal_curve.h"

namespace facenav::testing {
namespace {

constexpr double kFloor_v = 1e-7;       // lowest value of the recruitment curve
constexpr double kLeastShown_v = 1e-8;  // no amplitude is smaller
constexpr double kSmallest_pct = 1e-9;  // distance from the onset; below it nothing is evoked
constexpr int kExcitabilityNodes = 41, kNoiseNodes = 9;
constexpr double kLowest_pct = 30, kHighest_pct = 100;

/// Quantile of the standard normal distribution, by bisection.
double normalQuantile(double share) {
  double low = -9, high = 9;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (stimulation::normalBelow(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double noiseQuantile_v(const VirtualSubject& s, double share) {
  const double depth = -std::log(share);
  if (std::abs(s.noise_shape) < 1e-9) return s.noise_v - s.noise_scale_v * std::log(depth);
  return s.noise_v + s.noise_scale_v * (std::pow(depth, -s.noise_shape) - 1.0) / s.noise_shape;
}

/// Evoked part in decades above kFloor_v, without the pathway's variation.
double evoked(const VirtualSubject& s, double intensity_pct, double excitability_pct) {
  const double x = std::max(kSmallest_pct, intensity_pct - s.onset_pct + excitability_pct);
  return s.plateau / (1.0 + s.half / std::pow(x, s.steepness));
}

double normal(std::mt19937_64& random) { return std::normal_distribution<double>()(random); }

VirtualSubject drawAny(std::mt19937_64& random) {
  // Means and covariance of log10 half, log10 steepness, log10 onset: the only correlated parameters.
  static const Eigen::Vector3d kMean(3.646550162125, 0.426390035500, 1.666487134750);
  static const Eigen::Matrix3d kRoot = [] {
    Eigen::Matrix3d covariance;
    covariance << 7.202738820058, 0.569742608764, -0.197461987887,  //
        0.569742608764, 0.047425817251, -0.015113039713,            //
        -0.197461987887, -0.015113039713, 0.007107112788;
    return Eigen::Matrix3d(covariance.llt().matrixL());
  }();
  Eigen::Vector3d z;
  for (int i = 0; i < 3; ++i) z[i] = normal(random);
  const Eigen::Vector3d logs = kMean + kRoot * z;
  VirtualSubject s;
  s.half = std::pow(10.0, logs[0]);
  s.steepness = std::pow(10.0, logs[1]);
  s.onset_pct = std::pow(10.0, logs[2]);
  s.plateau = 7.0 - 2.467735071000 + std::sqrt(0.126168431583) * normal(random);
  s.pathway_spread = std::pow(10.0, -0.964533460250 + std::sqrt(0.022758778017) * normal(random));
  s.excitability_spread_pct = std::pow(10.0, 0.688273244000 + std::sqrt(0.023671071119) * normal(random));
  s.noise_v = std::pow(10.0, -5.081764824125 + std::sqrt(0.003570541967) * normal(random));
  s.noise_scale_v = 1.55e-6 * std::pow(1.5, normal(random));
  s.noise_shape = 0.14 * std::pow(2.0, normal(random));
  return s;
}

/// Implements the article's check on 300 pulses from 20 to 120 %: noise below, a large MEP above, no absurd
/// amplitude.
bool isPlausible(const VirtualSubject& s, std::mt19937_64& random) {
  bool is_silent = false, is_large = false;
  for (int i = 0; i < 300; ++i) {
    const double uv = drawMep_uv(s, 20.0 + i / 2.99, random);
    is_silent |= uv < 30;
    is_large |= uv > 1e3;
    if (uv <= 0.1 || uv >= 3e4) return false;
  }
  return is_silent && is_large;
}

}  // namespace

VirtualSubject drawSubject(std::mt19937_64& random) {
  for (;;) {
    const VirtualSubject s = drawAny(random);
    if (!isPlausible(s, random)) continue;
    const double threshold_pct = trueThreshold_pct(s);
    if (threshold_pct > kLowest_pct && threshold_pct < kHighest_pct) return s;
  }
}

double drawMep_uv(const VirtualSubject& s, double intensity_pct, std::mt19937_64& random) {
  const double excitability_pct = s.excitability_spread_pct * normal(random);
  const double pathway = s.pathway_spread * normal(random);
  const double share = std::uniform_real_distribution<double>(1e-12, 1.0)(random);
  const double v = noiseQuantile_v(s, share) +
                   kFloor_v * std::pow(10.0, pathway + evoked(s, intensity_pct, excitability_pct));
  return 1e6 * std::max(kLeastShown_v, v);
}

double responseProbability(const VirtualSubject& s, double intensity_pct, double criterion_uv) {
  static const auto kNormals = [] {
    std::array<double, kExcitabilityNodes> z;
    for (int i = 0; i < kExcitabilityNodes; ++i)
      z[std::size_t(i)] = normalQuantile((i + 0.5) / kExcitabilityNodes);
    return z;
  }();
  double sum = 0;
  for (int n = 0; n < kNoiseNodes; ++n) {
    const double missing_v = 1e-6 * criterion_uv - noiseQuantile_v(s, (n + 0.5) / kNoiseNodes);
    if (missing_v <= 0) {
      sum += kExcitabilityNodes;
      continue;
    }
    const double wanted = std::log10(missing_v / kFloor_v);
    for (const double z : kNormals)
      sum += stimulation::normalBelow((evoked(s, intensity_pct, s.excitability_spread_pct * z) - wanted) /
                                      s.pathway_spread);
  }
  return sum / (kNoiseNodes * kExcitabilityNodes);
}

double trueThreshold_pct(const VirtualSubject& s, double criterion_uv) {
  double low = 0, high = 200;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (responseProbability(s, middle, criterion_uv) < 0.5 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace facenav::testing
