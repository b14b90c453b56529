#include "brain_tissue.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "facenav/core/robust_statistics.h"
#include "facenav/volume/for_slices.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;
using Basis = Eigen::Matrix<double, 20, 1>;

constexpr double kBiasScale_mm = 80;  // half a head: keeps the polynomial's terms near 1
constexpr int kRounds = 4, kEmSteps = 40;
constexpr double kMaxLogGain = 1.2;  // limit of the polynomial outside the brain, where it extrapolates

Eigen::Vector4d powers(double x) { return {1, x, x * x, x * x * x}; }

/// Basis x^i y^j z^k with i + j + k <= 3, in the order of `alongRow`.
Basis basis(const Eigen::Vector3d& p) {
  const Eigen::Vector4d x = powers(p.x()), y = powers(p.y()), z = powers(p.z());
  Basis b;
  int at = 0;
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j)
      for (int k = 0; i + j + k <= 3; ++k) b[at++] = x[i] * y[j] * z[k];
  return b;
}

/// The polynomial on a row of constant y and z, as a cubic in x.
Eigen::Vector4d alongRow(const Basis& bias, double y_scaled, double z_scaled) {
  const Eigen::Vector4d y = powers(y_scaled), z = powers(z_scaled);
  Eigen::Vector4d cubic = Eigen::Vector4d::Zero();
  int at = 0;
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j)
      for (int k = 0; i + j + k <= 3; ++k) cubic[i] += bias[at++] * y[j] * z[k];
  return cubic;
}

struct Sample {
  Basis at;
  double value;
};

std::vector<Sample> samplesOf(const Volume& image, const Mask& core, const TissueModel& model) {
  std::vector<Sample> samples;
  const auto& n = image.grid.size;
  const int step = 2;  // every eighth voxel is enough
  for (int k = 0; k < n[2]; k += step)
    for (int j = 0; j < n[1]; j += step)
      for (int i = 0; i < n[0]; i += step) {
        if (!core.at(i, j, k)) continue;
        const double value = image.at(i, j, k);
        if (value <= 0) continue;
        const Eigen::Vector3d p = image.grid.toMri({double(i), double(j), double(k)}).mm;
        samples.push_back({basis((p - model.centre_mm) / kBiasScale_mm), value});
      }
  return samples;
}

double quantile(std::vector<double> values, double q) {
  return selectRank(values, std::size_t(q * double(values.size() - 1)));
}

double density(const TissueClass& c, double x) {
  const double z = (x - c.mean) / c.deviation;
  return c.share / c.deviation * std::exp(-0.5 * z * z);
}

using Classes = std::array<TissueClass, 3>;
constexpr int kBins = 128;

struct Histogram {
  explicit Histogram(const std::vector<double>& values)
      : low(quantile(values, 0.002)), high(quantile(values, 0.998)) {
    for (double v : values)
      if (v >= low && v <= high && high > low)
        count[std::min(kBins - 1, int((v - low) / (high - low) * kBins))] += 1;
  }
  double centre(int bin) const { return low + (bin + 0.5) * (high - low) / kBins; }
  TissueClass between(int from, int to) const {
    double n = 0, sum = 0, squares = 0;
    for (int b = from; b < to; ++b)
      n += count[b], sum += count[b] * centre(b), squares += count[b] * centre(b) * centre(b);
    if (n == 0) return {centre(from), least_deviation(), 0};
    return {sum / n, std::max(least_deviation(), std::sqrt(std::max(0.0, squares / n - sum * sum / n / n))),
            n};
  }
  double least_deviation() const { return 0.02 * (high - low); }
  double low, high;
  std::array<double, kBins> count{};
};

/// The two thresholds with the least variance within the three classes (Otsu 1979).
Classes otsuClasses(const Histogram& h) {
  Classes best{};
  double least = 1e300;
  for (int first = 4; first < kBins - 8; first += 2)
    for (int second = first + 4; second < kBins - 4; second += 2) {
      const Classes c{h.between(0, first), h.between(first, second), h.between(second, kBins)};
      double within = 0;
      for (const auto& k : c) within += k.share * k.deviation * k.deviation;
      if (within < least) least = within, best = c;
    }
  const double total = best[0].share + best[1].share + best[2].share;
  for (auto& k : best) k.share /= total;
  return best;
}

Classes maximiseExpectation(const Histogram& h, Classes c) {
  for (int step = 0; step < kEmSteps; ++step) {
    std::array<double, 3> n{}, sum{}, squares{};
    for (int bin = 0; bin < kBins; ++bin) {
      const double x = h.centre(bin);
      const std::array<double, 3> p{density(c[0], x), density(c[1], x), density(c[2], x)};
      const double total = p[0] + p[1] + p[2] + 1e-12;
      for (int k = 0; k < 3; ++k) {
        const double w = h.count[bin] * p[k] / total;
        n[k] += w, sum[k] += w * x, squares[k] += w * x * x;
      }
    }
    for (int k = 0; k < 3; ++k) {
      if (n[k] < 1) continue;
      c[k].mean = sum[k] / n[k];
      c[k].deviation =
          std::max(h.least_deviation(), std::sqrt(std::max(0.0, squares[k] / n[k] - c[k].mean * c[k].mean)));
      c[k].share = n[k] / (n[0] + n[1] + n[2]);
    }
  }
  return c;
}

}  // namespace

double TissueModel::contrast() const { return white.mean > 0 ? (white.mean - grey.mean) / white.mean : 0; }

Mask ballOf(const volume::VoxelGrid& grid, const Eigen::Vector3d& centre_mm, double radius_mm) {
  Mask ball{grid, std::vector<std::uint8_t>(grid.count())};
  std::size_t at = 0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i, ++at)
        ball.voxels[at] = (grid.toMri({double(i), double(j), double(k)}).mm - centre_mm).norm() < radius_mm;
  return ball;
}

TissueModel fitRoughBias(const Volume& image, const Eigen::Vector3d& centre_mm, double radius_mm, float air) {
  constexpr int kTrims = 12, kWide = 3;
  constexpr double kWide_log = 0.8, kBelow_log = 0.15,
                   kAbove_log = 0.3;  // the last trims keep only white matter
  TissueModel model;
  model.centre_mm = centre_mm;
  Mask ball = ballOf(image.grid, centre_mm, radius_mm);
  for (std::size_t v = 0; v < ball.voxels.size(); ++v) ball.voxels[v] &= image.voxels[v] > air;
  const auto samples = samplesOf(image, ball, model);
  if (samples.size() < 1000) return model;
  std::vector<double> logs;
  for (const auto& s : samples) logs.push_back(std::log(s.value));
  const double middle = quantile(logs, 0.6);
  for (int trim = 0; trim < kTrims; ++trim) {
    Eigen::Matrix<double, 20, 20> normal = Eigen::Matrix<double, 20, 20>::Zero();
    Basis right = Basis::Zero();
    const double below = trim < kWide ? kWide_log : kBelow_log, above = trim < kWide ? kWide_log : kAbove_log;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double residual = logs[i] - middle - model.bias.dot(samples[i].at);
      if (residual < -below || residual > above) continue;
      normal.noalias() += samples[i].at * samples[i].at.transpose();
      right += (logs[i] - middle) * samples[i].at;
    }
    const double scale = normal.trace() / 20;
    int term = 0;
    for (int i = 0; i <= 3; ++i)
      for (int j = 0; i + j <= 3; ++j)
        for (int k = 0; i + j + k <= 3; ++k, ++term)
          normal(term, term) += scale * (i + j + k == 3 ? 1e3 : 1e-3);
    model.bias = normal.ldlt().solve(right);
  }
  model.bias[0] = 0;  // keeps the overall gain
  return model;
}

TissueModel fitTissue(const Volume& image, const Mask& core, const TissueModel* start) {
  TissueModel model;
  model.centre_mm = image.grid.centre().mm;
  const auto samples = samplesOf(image, core, model);
  if (samples.size() < 1000) return model;
  Classes c{};
  if (start) c = {start->fluid, start->grey, start->white};
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> values;
    for (const auto& s : samples) values.push_back(s.value * std::exp(-model.bias.dot(s.at)));
    const Histogram histogram(values);
    if (!(histogram.high > histogram.low)) return model;  // one value throughout: no tissues
    c = maximiseExpectation(histogram, round == 0 && !start ? otsuClasses(histogram) : c);
    if (round + 1 == kRounds) break;
    Eigen::Matrix<double, 20, 20> normal = Eigen::Matrix<double, 20, 20>::Zero();
    Basis right = Basis::Zero();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double grey = density(c[1], values[i]), white = density(c[2], values[i]);
      const double weight = (grey + white) / (density(c[0], values[i]) + grey + white + 1e-12);
      if (weight < 0.5) continue;
      const double mean = (grey * c[1].mean + white * c[2].mean) / (grey + white);
      const double w = weight * (grey + white > 0 ? std::max(grey, white) / (grey + white) : 0);
      normal.noalias() += w * samples[i].at * samples[i].at.transpose();
      right += w * std::log(samples[i].value / mean) * samples[i].at;
    }
    normal.diagonal().array() +=
        1e-3 * normal.trace() / 20;  // keeps the high orders small where the samples do not fix them
    model.bias = normal.ldlt().solve(right);
  }
  model.fluid = c[0], model.grey = c[1], model.white = c[2];
  return model;
}

Volume corrected(Volume image, const TissueModel& model) {
  const auto& n = image.grid.size;
  const double step = image.grid.spacing_mm().x() / kBiasScale_mm;
  volume::forSlices(n[2], [&](int k) {
    std::size_t at = image.grid.index(0, 0, k);
    for (int j = 0; j < n[1]; ++j) {
      const Eigen::Vector3d row =
          (image.grid.toMri({0, double(j), double(k)}).mm - model.centre_mm) / kBiasScale_mm;
      const Eigen::Vector4d c = alongRow(model.bias, row.y(), row.z());
      for (int i = 0; i < n[0]; ++i, ++at) {
        const double x = row.x() + i * step;
        const double gain = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
        image.voxels[at] *= float(std::exp(-std::clamp(gain, -kMaxLogGain, kMaxLogGain)));
      }
    }
  });
  return image;
}

}  // namespace facenav::segmentation
