#include "brain_tissue.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;
using Basis = Eigen::Matrix<double, 20, 1>;

constexpr double kBiasScale_mm = 80;  // half a head: keeps the polynomial's terms near 1
constexpr int kRounds = 4, kEmSteps = 40;
constexpr double kMaxLogGain = 1.2;  // outside the brain the polynomial is not trusted further than this

Basis basis(const Eigen::Vector3d& p) {
  Basis b;
  int at = 0;
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j)
      for (int k = 0; i + j + k <= 3; ++k)
        b[at++] = std::pow(p.x(), i) * std::pow(p.y(), j) * std::pow(p.z(), k);
  return b;
}

struct Sample {
  Basis at;
  double value;
};

std::vector<Sample> samplesOf(const Volume& image, const Mask& core, const TissueModel& model) {
  std::vector<Sample> samples;
  const auto& n = image.grid.size;
  const int step = 2;  // every eighth voxel says as much
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
  auto at = values.begin() + std::ptrdiff_t(q * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double density(const TissueClass& c, double x) {
  const double z = (x - c.mean) / c.deviation;
  return c.share / c.deviation * std::exp(-0.5 * z * z);
}

/// Expectation maximisation over a histogram of the values; `c` is the start and the result.
void fitClasses(const std::vector<double>& values, std::array<TissueClass, 3>& c) {
  const double low = quantile(values, 0.002), high = quantile(values, 0.998);
  std::array<double, 256> histogram{};
  for (double v : values)
    if (v >= low && v <= high) histogram[std::min(255, int((v - low) / (high - low) * 256))] += 1;
  const double least = 0.02 * (high - low);
  for (int step = 0; step < kEmSteps; ++step) {
    std::array<double, 3> n{}, sum{}, squares{};
    for (int bin = 0; bin < 256; ++bin) {
      const double x = low + (bin + 0.5) * (high - low) / 256;
      std::array<double, 3> p{density(c[0], x), density(c[1], x), density(c[2], x)};
      const double total = p[0] + p[1] + p[2] + 1e-12;
      for (int k = 0; k < 3; ++k) {
        const double w = histogram[bin] * p[k] / total;
        n[k] += w, sum[k] += w * x, squares[k] += w * x * x;
      }
    }
    for (int k = 0; k < 3; ++k) {
      if (n[k] < 1) continue;
      c[k].mean = sum[k] / n[k];
      c[k].deviation = std::max(least, std::sqrt(std::max(0.0, squares[k] / n[k] - c[k].mean * c[k].mean)));
      c[k].share = n[k] / (n[0] + n[1] + n[2]);
    }
  }
}

}  // namespace

double TissueModel::contrast() const { return white.mean > 0 ? (white.mean - grey.mean) / white.mean : 0; }

TissueModel fitTissue(const Volume& image, const Mask& core) {
  TissueModel model;
  model.centre_mm = image.grid.centre().mm;
  const auto samples = samplesOf(image, core, model);
  if (samples.size() < 1000) return model;
  std::array<TissueClass, 3> c;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> values;
    for (const auto& s : samples) values.push_back(s.value * std::exp(-model.bias.dot(s.at)));
    if (round == 0) {
      const double middle = quantile(values, 0.5), top = quantile(values, 0.98);
      c = {TissueClass{0.45 * middle, 0.12 * middle, 0.1},
           TissueClass{quantile(values, 0.35), 0.1 * middle, 0.5},
           TissueClass{0.5 * (quantile(values, 0.75) + top), 0.1 * middle, 0.4}};
    }
    fitClasses(values, c);
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
        1e-3 * normal.trace() / 20;  // keeps the high orders small where nothing asks for them
    model.bias = normal.ldlt().solve(right);
  }
  model.fluid = c[0], model.grey = c[1], model.white = c[2];
  return model;
}

Volume corrected(const Volume& image, const TissueModel& model) {
  Volume out = image;
  const auto& n = image.grid.size;
  std::size_t at = 0;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i, ++at) {
        const Eigen::Vector3d p = image.grid.toMri({double(i), double(j), double(k)}).mm;
        const double gain = model.bias.dot(basis((p - model.centre_mm) / kBiasScale_mm));
        out.voxels[at] = float(image.voxels[at] * std::exp(-std::clamp(gain, -kMaxLogGain, kMaxLogGain)));
      }
  return out;
}

}  // namespace facenav::segmentation
