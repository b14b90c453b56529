#include "skin_likelihood.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "cloud/cube_numbers.h"
#include "cloud/skin_patches.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::registration {
namespace {

// Possible sizes of the misfit: log-normal with median 0.35 mm, one sigma is a factor of e^0.8. Possible
// sizes of detail: of the skin (noise of the cloud, the scan's voxels, stubble) and of covers (cloth, hair).
constexpr std::array<double, 6> kSize_mm{0.1, 0.2, 0.4, 0.8, 1.6, 3.2},
    kSizeShare{0.10, 0.28, 0.35, 0.21, 0.06, 0.0};
constexpr std::array<double, 4> kDetail_mm{0.1, 0.2, 0.4, 0.8}, kDetailShare{0.25, 0.35, 0.3, 0.1};
// These are the shares for another person's scan, at the pose where it fits best.
constexpr std::array<double, 6> kOtherSizeShare{0.0, 0.0, 0.0, 0.02, 0.3, 0.68};
constexpr std::array<double, 4> kOtherDetailShare{0.0, 0.01, 0.2, 0.79};
constexpr std::array<double, 3> kCoverDetail_mm{0.3, 1.0, 3.0};
// Number of independent values of detail in a fully visible patch. The matcher's window leaves some 20; a
// lower number accounts for the unmodelled correlation between neighbouring patches.
constexpr double kGrains = 5.0;
constexpr double kHair_mm = 8.0, kForeignFar_mm = 60.0;  // reach of hair; of hands and coils
constexpr double kBehind = 0.15, kBehind_mm = 3.0;       // behind the skin lie only eyes and gross errors
constexpr double kNowhere_per_mm = 0.03;  // density without a counterpart: nearly no information
constexpr double kLeastOutside = 0.3;
constexpr double kGross = 0.05, kGross_per_mm = 0.05;  // outliers within a patch
// Log odds: cost of each pair of neighbours with different labels, and prior of a cover over mostly bare
// skin. A mask over half a face costs 8 in total.
constexpr double kRim = 0.3, kBare = -0.15, kHairy = 0.06;

constexpr double kNever = -1e300;  // logarithm of no share

template <std::size_t kCount>
std::array<double, kCount> logsOf(const std::array<double, kCount>& shares) {
  std::array<double, kCount> logs{};
  for (std::size_t s = 0; s < kCount; ++s) logs[s] = shares[s] > 0 ? std::log(shares[s]) : kNever;
  return logs;
}

double skinDensity(double residual_mm, double sigma_mm) {
  const double u = residual_mm / sigma_mm;
  return std::exp(-0.5 * u * u) / (sigma_mm * std::sqrt(2 * M_PI));
}

double coverDensity(double residual_mm) {
  if (residual_mm <= 0) return kBehind / kBehind_mm * std::exp(residual_mm / kBehind_mm);
  constexpr double kArea = 0.9064;  // integral of exp(-x^4) from 0
  // A hand or a coil in front of the face is rare, but must not move the pose elsewhere.
  return std::max(kLeastOutside * kNowhere_per_mm,
                  0.65 / (kArea * kHair_mm) * std::exp(-std::pow(residual_mm / kHair_mm, 4)) +
                      0.2 / kForeignFar_mm * std::exp(-residual_mm / kForeignFar_mm));
}

double logSum(const double* values, std::size_t count) {
  const double most = *std::max_element(values, values + count);
  double sum = 0;
  for (std::size_t v = 0; v < count; ++v) sum += std::exp(values[v] - most);
  return most + std::log(sum);
}

// Log odds beyond 10 (1 in 20 thousand) are treated as certain, which saves the exponential and the entropy.
constexpr double kCertain = 10.0;

double logistic(double log_odds) {
  if (std::abs(log_odds) > kCertain) return log_odds > 0 ? 1.0 : 0.0;
  return double(1.0f / (1.0f + std::exp(-float(log_odds))));
}

/// log(exp(a) + exp(b)) or slightly more, fast.
double logEither(double a, double b) {
  const double apart = std::abs(a - b);
  return std::max(a, b) + (apart > 8.0 ? 4e-4 : double(std::exp(-float(apart))));
}

double entropy(double q) {
  const auto part = [](float p) { return p > 1e-12f ? -p * std::log(p) : 0.0f; };
  return double(part(float(q)) + part(float(1 - q)));
}

/// Log density of points at a distance from the middle of a patch with a given detail, relative to "no
/// counterpart". A look-up table with error 0.002.
class LogDetail {
 public:
  explicit LogDetail(double detail_mm) : per_mm_(float(kSteps / (kMost * detail_mm))) {
    for (int i = 0; i <= kSteps + 1; ++i)
      values_[std::size_t(i)] = float(std::log(
          ((1 - kGross) * skinDensity(double(i) / double(per_mm_), detail_mm) + kGross * kGross_per_mm) /
          kNowhere_per_mm));
  }
  /// Mean log density over the residuals.
  double operator()(const std::vector<float>& residuals_mm, float middle_mm) const {
    float sum = 0;
    for (const float r : residuals_mm) {
      const float at = std::min(std::abs(r - middle_mm) * per_mm_, float(kSteps));
      const auto i = std::size_t(at);
      sum += values_[i] + (at - float(i)) * (values_[i + 1] - values_[i]);
    }
    return double(sum) / double(residuals_mm.size());
  }

 private:
  static constexpr int kSteps = 240;
  static constexpr double kMost = 6.0;  // range of the table, in sigma
  float per_mm_;
  std::array<float, kSteps + 2> values_;
};

}  // namespace

/// Log likelihoods of a patch's points: bare, by detail and size, or covered.
struct SkinLikelihood::Patch {
  std::array<std::array<double, kSizes>, kDetails> bare{};
  double covered = 0.0;
  double prior = kBare;  // log odds of being covered
};

/// Logarithms of the shares of sizes and details.
struct SkinLikelihood::Prior {
  std::array<double, kSizes> sizes;
  std::array<double, kDetails> details;
};
const SkinLikelihood::Prior SkinLikelihood::kOwn{logsOf(kSizeShare), logsOf(kDetailShare)};
const SkinLikelihood::Prior SkinLikelihood::kOther{logsOf(kOtherSizeShare), logsOf(kOtherDetailShare)};

struct SkinLikelihood::Labels {
  double log_evidence = 0.0;
  std::vector<double> covered;  // probability for each patch
};

SkinLikelihood::SkinLikelihood(const ScalpField& scalp, const PointCloud<Camera>& face,
                               const std::vector<int>& points, double noise_mm, double patch_mm)
    : regions_(scalp.noseTip_mm()), noise_mm_(noise_mm) {
  CubeNumbers numbers(patch_mm);
  std::vector<Eigen::Vector3i> cubes;
  std::vector<double> counts;
  patch_of_.reserve(points.size());
  for (const int p : points) {
    const Eigen::Vector3f at = face.points_mm[std::size_t(p)].cast<float>();
    const int patch = numbers.of(at);
    if (std::size_t(patch) == cubes.size())
      cubes.push_back((at / float(patch_mm)).array().floor().cast<int>()), counts.push_back(0);
    patch_of_.push_back(patch);
    ++counts[std::size_t(patch)];
  }
  full_ = upperMedian(counts);
  neighbours_.resize(cubes.size());
  for (std::size_t a = 0; a < cubes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if ((cubes[a] - cubes[b]).cwiseAbs().maxCoeff() == 1)
        neighbours_[a].push_back(int(b)), neighbours_[b].push_back(int(a));
}

std::vector<SkinLikelihood::Patch> SkinLikelihood::gather(const std::vector<PointMatch>& matches) const {
  const auto noisy = [this](double detail_mm) { return std::hypot(detail_mm, noise_mm_); };
  const std::array<LogDetail, kDetails> bare_detail{
      LogDetail(noisy(kDetail_mm[0])), LogDetail(noisy(kDetail_mm[1])), LogDetail(noisy(kDetail_mm[2])),
      LogDetail(noisy(kDetail_mm[3]))};
  const std::array<LogDetail, 3> cover_detail{LogDetail(noisy(kCoverDetail_mm[0])),
                                              LogDetail(noisy(kCoverDetail_mm[1])),
                                              LogDetail(noisy(kCoverDetail_mm[2]))};
  std::vector<Patch> patches(neighbours_.size());
  std::vector<std::vector<float>> residuals(patches.size());
  std::vector<Eigen::Vector3f> sums(patches.size(), Eigen::Vector3f::Zero());
  for (std::size_t p = 0; p < matches.size(); ++p) {
    if (!matches[p].is_valid) continue;
    auto& residuals_of_patch = residuals[std::size_t(patch_of_[p])];
    if (residuals_of_patch.empty()) residuals_of_patch.reserve(std::size_t(2 * full_));
    residuals_of_patch.push_back(matches[p].residual_mm);
    sums[std::size_t(patch_of_[p])] += matches[p].at_mri_mm;
  }
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (residuals[i].empty()) continue;
    Patch& patch = patches[i];
    const double n = double(residuals[i].size());
    const Eigen::Vector3d at = sums[i].cast<double>() / n;
    const double foreign = regions_.foreignShare(at);
    if (foreign > kHairy) patch.prior = std::max(kBare, std::log(foreign / (1 - foreign)));
    // Hair is one connected object. If hair is probable, patches count as fewer independent points.
    const double share = std::min(1.0, n / full_) * (1 - foreign), grains = kGrains * share;
    const float m_mm = selectRank(residuals[i], residuals[i].size() / 2);
    const double m = double(m_mm);
    for (std::size_t d = 0; d < kDetails; ++d) {
      const double detail = grains * bare_detail[d](residuals[i], m_mm);
      const double mean2 = std::pow(noisy(kDetail_mm[d]), 2) / std::max(grains, 1.0);
      for (std::size_t s = 0; s < kSizes; ++s) {
        const double size2 = kSize_mm[s] * kSize_mm[s] + mean2;
        patch.bare[d][s] = detail + share * 0.5 * (double(std::log(float(mean2 / size2))) - m * m / size2);
      }
    }
    patch.covered = -1e300;
    for (std::size_t d = 0; d < kCoverDetail_mm.size(); ++d) {
      const double mean_mm = noisy(kCoverDetail_mm[d]) * std::sqrt(2 * M_PI / std::max(grains, 1.0));
      patch.covered = std::max(patch.covered, grains * cover_detail[d](residuals[i], m_mm) +
                                                  share * std::log(mean_mm * coverDensity(m)));
    }
  }
  return patches;
}

double SkinLikelihood::pull(const std::vector<double>& covered, std::size_t patch) const {
  double sum = 0;
  for (const int j : neighbours_[patch]) sum += covered[std::size_t(j)];
  return kRim * (2 * sum - double(neighbours_[patch].size()));
}

/// Contribution of the labels alone to the bound of the evidence.
double SkinLikelihood::energy(const std::vector<double>& covered, const std::vector<Patch>& patches) const {
  double sum = 0;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const double q = covered[i];
    // Each pair is counted twice. pull() is its agreement minus its disagreement.
    sum += q * patches[i].prior + entropy(q) + 0.5 * (q - 0.5) * pull(covered, i);
  }
  return sum;
}

/// Labels from each patch alone, without neighbours.
std::vector<double> SkinLikelihood::coveredAlone(const std::vector<Patch>& patches, std::size_t detail) {
  constexpr std::size_t kUsualSize = 1;
  std::vector<double> covered(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i)
    covered[i] = patches[i].covered > patches[i].bare[detail][kUsualSize] ? 1.0 : 0.0;
  return covered;
}

/// Mean field over labels and sizes for one detail, starting from the given labels.
SkinLikelihood::Labels SkinLikelihood::label(const std::vector<Patch>& patches, std::size_t detail,
                                             const Prior& prior, std::vector<double> covered_at_first) const {
  constexpr int kMostSweeps = 15;
  constexpr double kSettled = 0.01;
  Labels labels{0.0, std::move(covered_at_first)};
  std::array<double, kSizes> share{}, logs{};
  const auto bareOf = [&](const Patch& patch) {
    double sum = 0;
    for (std::size_t s = 0; s < kSizes; ++s) sum += share[s] * patch.bare[detail][s];
    return sum;
  };
  const auto bySizes = [&] {
    logs = prior.sizes;
    for (std::size_t i = 0; i < patches.size(); ++i)
      for (std::size_t s = 0; s < kSizes; ++s)
        logs[s] += (1 - labels.covered[i]) * patches[i].bare[detail][s];
    return logSum(logs.data(), kSizes);
  };
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    const double by_sizes = bySizes();
    for (std::size_t s = 0; s < kSizes; ++s) share[s] = std::exp(logs[s] - by_sizes);
    double change = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const double alone = patches[i].covered - bareOf(patches[i]) + patches[i].prior;
      // Neighbours cannot outweigh log odds beyond this.
      const bool is_certain = std::abs(alone) > kCertain + kRim * double(neighbours_[i].size());
      const double covered = logistic(is_certain ? alone : alone + pull(labels.covered, i));
      change = std::max(change, std::abs(covered - labels.covered[i]));
      labels.covered[i] = covered;
    }
    if (change < kSettled) break;
  }
  labels.log_evidence = bySizes() + energy(labels.covered, patches);
  for (std::size_t i = 0; i < patches.size(); ++i)
    labels.log_evidence += labels.covered[i] * patches[i].covered;
  return labels;
}

/// Evidence of the labels without observations: the normalisation.
SkinLikelihood::Labels SkinLikelihood::unlabelled(const std::vector<Patch>& patches) const {
  std::vector<Patch> blank(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) blank[i].prior = patches[i].prior;
  return label(blank, 0, kOwn, std::vector<double>(blank.size(), 0.0));
}

/// Upper bound of the evidence for this detail: each patch takes its best label, and all neighbours agree.
double SkinLikelihood::mostEvidence(const std::vector<Patch>& patches, std::size_t detail, const Prior& prior,
                                    double agreement) {
  double most = -1e300;
  for (std::size_t s = 0; s < kSizes; ++s) {
    if (prior.sizes[s] <= kNever) continue;
    double sum = agreement;
    for (const Patch& patch : patches) sum += logEither(patch.bare[detail][s], patch.covered + patch.prior);
    most = std::max(most, sum);
  }
  return most;
}

template <class Visitor>
double SkinLikelihood::sumOut(const std::vector<Patch>& patches, const Prior& prior, Visitor&& visit) const {
  double agreement = 0;
  for (const auto& neighbours : neighbours_) agreement += 0.25 * kRim * double(neighbours.size());
  std::array<std::pair<double, std::size_t>, kDetails> promising;
  for (std::size_t d = 0; d < kDetails; ++d)
    promising[d] = {prior.details[d] + mostEvidence(patches, d, prior, agreement), d};
  std::sort(promising.begin(), promising.end(), std::greater<>());
  std::vector<double> logs;
  std::vector<Labels> all;
  for (const auto& [most, d] : promising) {
    if (!logs.empty() && most < *std::max_element(logs.begin(), logs.end()) - kCertain) break;
    Labels labels = label(patches, d, prior, coveredAlone(patches, d));
    Labels other = label(patches, d, prior, std::vector<double>(patches.size(), 0.0));
    if (other.log_evidence > labels.log_evidence) labels = std::move(other);
    logs.push_back(prior.details[d] + labels.log_evidence);
    all.push_back(std::move(labels));
  }
  const double sum = logSum(logs.data(), logs.size());
  for (std::size_t l = 0; l < logs.size(); ++l) visit(std::exp(logs[l] - sum), all[l].covered);
  return sum;
}

double SkinLikelihood::operator()(const std::vector<PointMatch>& matches) const {
  const auto patches = gather(matches);
  return sumOut(patches, kOwn, [](double, const std::vector<double>&) {}) - unlabelled(patches).log_evidence;
}

SkinLikelihood::ByPerson SkinLikelihood::byPerson(const std::vector<PointMatch>& matches) const {
  const auto patches = gather(matches);
  const auto nothing = [](double, const std::vector<double>&) {};
  return {sumOut(patches, kOwn, nothing), sumOut(patches, kOther, nothing)};
}

std::vector<float> SkinLikelihood::covered(const std::vector<PointMatch>& matches) const {
  std::vector<double> sum(neighbours_.size(), 0.0);
  sumOut(gather(matches), kOwn, [&](double share, const std::vector<double>& covered) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * covered[i];
  });
  std::vector<float> out;
  for (const int patch : patch_of_) out.push_back(float(sum[std::size_t(patch)]));
  return out;
}

}  // namespace facenav::registration
