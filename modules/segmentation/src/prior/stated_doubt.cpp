#include "prior/stated_doubt.h"

#include <cmath>
#include <utility>

namespace facenav::segmentation {
namespace {

std::pair<double, double> scaleAndPower(ContrastKind kind, const PriorUse& use) {
  switch (kind) {
    case ContrastKind::t1:
      return {use.doubt_t1_scale_mm, use.doubt_t1_power};
    case ContrastKind::weak_t1:
      return {use.doubt_weak_scale_mm, use.doubt_weak_power};
    case ContrastKind::t2:
      return {use.doubt_t2_scale_mm, use.doubt_t2_power};
    case ContrastKind::flair:
      return {use.doubt_flair_scale_mm, use.doubt_flair_power};
    case ContrastKind::proton_density:
      return {use.doubt_pd_scale_mm, use.doubt_pd_power};
  }
  return {1, 1};
}

}  // namespace

float statedDoubt_mm(float doubt_mm, ContrastKind kind, const PriorUse& use) {
  const auto [scale_mm, power] = scaleAndPower(kind, use);
  const double scaled_mm = scale_mm * std::pow(double(doubt_mm), power);
  return float(scaled_mm / (1 + scaled_mm / use.doubt_most_mm));
}

}  // namespace facenav::segmentation
