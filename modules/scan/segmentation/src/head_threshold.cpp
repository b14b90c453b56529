#include "head_threshold.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/core/error.h"

namespace facenav::segmentation {
namespace {

constexpr double kCtSkin_hu = -300.0;  // air -1000, skin and fat -100..50, pillows below -700

// Noise alone, split in two classes, gives 1.5; heads on 2 mm blocks give 15 and more.
constexpr double kLeastContrastToNoise = 4.0;

double share(const std::vector<float>& sorted, double low, double high) {
  const auto from = std::lower_bound(sorted.begin(), sorted.end(), float(low));
  const auto to = std::lower_bound(sorted.begin(), sorted.end(), float(high));
  return double(to - from) / double(sorted.size());
}

double quantile(const std::vector<float>& sorted, std::size_t begin, std::size_t end, double fraction) {
  return sorted[begin + std::size_t(fraction * double(end - begin - 1))];
}

/// Recognises Hounsfield units: many values at air, many at soft tissue and fat, hardly any between.
bool looksLikeCt(const std::vector<float>& sorted) {
  const double air = share(sorted, -1e9, -850), between = share(sorted, -800, -250),
               soft = share(sorted, -180, 250);
  return air > 0.08 && soft > 0.05 && between < 0.5 * soft && air + between + soft > 0.75;
}

/// Split with the greatest variance between the classes (Otsu 1979), as an index into the sorted values.
/// Values above the 98th percentile count as that percentile, so that bright fat does not raise the split.
std::size_t otsuSplit(const std::vector<float>& sorted) {
  const float cap = sorted[std::size_t(0.98 * double(sorted.size() - 1))];
  double total = 0;
  for (const float v : sorted) total += std::min(v, cap);
  double below = 0, best = -1;
  std::size_t split = 0;
  for (std::size_t n = 1; n < sorted.size(); ++n) {
    below += std::min(sorted[n - 1], cap);
    const double gap = below / double(n) - (total - below) / double(sorted.size() - n);
    const double between = gap * gap * double(n) * double(sorted.size() - n);
    if (between > best) best = between, split = n;
  }
  return split;
}

/// Mode by the half-sample method (Robertson and Cryer 1974): repeatedly takes the densest half.
double halfSampleMode(const std::vector<float>& sorted, std::size_t begin, std::size_t end) {
  while (end - begin > 16) {
    const std::size_t half = (end - begin) / 2;
    std::size_t best = begin;
    for (std::size_t b = begin; b + half < end; ++b)
      if (sorted[b + half] - sorted[b] < sorted[best + half] - sorted[best]) best = b;
    begin = best;
    end = best + half + 1;
  }
  return sorted[(begin + end) / 2];
}

}  // namespace

HeadThreshold findHeadThreshold(std::vector<float> sorted, const std::string& modality) {
  sorted.erase(std::remove_if(sorted.begin(), sorted.end(), [](float v) { return !std::isfinite(v); }),
               sorted.end());
  std::sort(sorted.begin(), sorted.end());
  if (sorted.size() < 100 || !(sorted.back() > sorted.front()))
    throw Error("no head in this volume: it is empty", {}, "choose another series");
  HeadThreshold out;
  out.is_ct = modality == "CT" || (modality != "MR" && looksLikeCt(sorted));
  if (out.is_ct && !looksLikeCt(sorted)) out.is_ct = share(sorted, -1e9, -500) > 0.05;
  const std::size_t split = otsuSplit(sorted);
  out.air = halfSampleMode(sorted, 0, split);
  out.tissue = quantile(sorted, split, sorted.size(), 0.5);
  // Spread below the mode and, since many scanners set air to zero, up to the median of the darker class.
  const std::size_t mode_at =
      std::size_t(std::lower_bound(sorted.begin(), sorted.end(), float(out.air)) - sorted.begin());
  const double lower = mode_at > 10 ? out.air - quantile(sorted, 0, mode_at, 0.32) : 0.0;
  out.air_sigma = std::max(0.0, lower);
  const double contrast = out.tissue - out.air;
  if (!out.is_ct && contrast < kLeastContrastToNoise * out.air_sigma)
    throw Error("no head in this volume: nothing stands out from the noise", {}, "choose another series");
  out.value = out.is_ct ? kCtSkin_hu
                        : out.air + std::max(0.16 * contrast, std::min(5 * out.air_sigma, 0.35 * contrast));
  return out;
}

}  // namespace facenav::segmentation
