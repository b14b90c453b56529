#include "level_measurement.h"

#include <algorithm>
#include <cmath>

#include "light_field.h"
#include "patch_appearance.h"

namespace facenav::head_tracking {
namespace {

constexpr double kLeastLightChange = 0.02;
constexpr float kAlikeShare = 0.6f;  // share of the expected correlation
constexpr int kFewestAlike = 10;     // patches in view of both cameras; no result with fewer
constexpr int kLightSteps = 2;       // steps of a fit in which the light is measured

patch::Image imageOf(const BlurredImage& image) {
  return {image.pixels.ptr<std::uint16_t>(0),
          int(image.pixels.step1()),
          image.origin.x,
          image.origin.y,
          image.pixels.cols,
          image.pixels.rows};
}

}  // namespace

LevelMeasurement::LevelMeasurement(const cameras::StereoRig& rig, const PatchModel& model,
                                   const PatchLevel& level, const std::array<ImagePyramid, 2>& now)
    : rig_(rig), model_(model), level_(level), measurements_(level.patches.size()) {
  for (int c = 0; c < 2; ++c) images_[c] = imageOf(now[c].level[level.level]);
  noise_share_ = float(patch::kSamples * noiseShare(level.level) * model.noise_grey * model.noise_grey);
}

void LevelMeasurement::placeAt(const Eigen::Isometry3d& motion) {
  placed_[0] = place(level_, rig_.left, 0, motion);
  placed_[1] = place(level_, rig_.right, 1, rig_.right_T_left.isometry() * motion);
}

void LevelMeasurement::measure(const Eigen::Isometry3d& motion) {
  for (auto& measurement : measurements_) measurement = {};
  ++rounds_;
  const Eigen::Isometry3d camera_T_head[2] = {motion, rig_.right_T_left.isometry() * motion};
  for (int c = 0; c < 2; ++c) {
    const auto& placements = placed_[c].placements;
    if (images_[c].width < 2 || images_[c].height < 2) continue;
    sums_[c].resize(placements.size());
    patch::kernel()(images_[c], level_.samples(c), floatsOf(camera_T_head[c]).data(), placements.data(),
                    int(placements.size()), sums_[c].data());
    for (std::size_t k = 0; k < placements.size(); ++k) see(c, k);
  }
  for (int c = 0; c < 2; ++c)
    for (std::size_t k = 0; k < placed_[c].placements.size(); ++k) displace(c, k);
}

void LevelMeasurement::markCentres(const Eigen::Isometry3d& motion) {
  const Eigen::Isometry3d camera_T_head[2] = {motion, rig_.right_T_left.isometry() * motion};
  for (int c = 0; c < 2; ++c)
    for (const auto& at : placed_[c].placements) {
      const Eigen::Vector2f flat =
          (camera_T_head[c] * level_.patches[at.patch].centre_mm).hnormalized().cast<float>();
      measurements_[at.patch][c].px << at.d[0] * flat.x() + at.d[1] * flat.y() + at.offset[0],
          at.d[2] * flat.x() + at.d[3] * flat.y() + at.offset[1];
    }
}

double LevelMeasurement::likeness() const {
  int seen = 0, alike = 0;
  for (const auto& measurement : measurements_)
    for (const auto& one : measurement)
      if (one.is_visible && one.expected_ncc > 0.3f)
        ++seen, alike += one.ncc > kAlikeShare * one.expected_ncc;
  return seen < kFewestAlike ? 0.0 : double(alike) / seen;
}

double LevelMeasurement::lightChange() const {
  std::vector<float> ratios;
  for (const auto& measurement : measurements_)
    for (const auto& one : measurement)
      if (one.is_visible && one.ncc > 0.5f * one.expected_ncc) ratios.push_back(one.brightness);
  if (ratios.size() < std::size_t(kFewestAlike)) return kLeastLightChange;
  const auto quantile = [&](double share) {
    const auto at = ratios.begin() + std::ptrdiff_t(share * double(ratios.size()));
    std::nth_element(ratios.begin(), at, ratios.end());
    return double(*at);
  };
  const double low = quantile(0.16), middle = quantile(0.5), high = quantile(0.84);
  return std::max(kLeastLightChange, 0.5 * (high - low) / std::max(0.1, middle));
}

void LevelMeasurement::see(int camera, std::size_t k) {
  const auto& sums = sums_[camera][k];
  const int index = placed_[camera].placements[k].patch;
  const PatchView& view = level_.patches[index].view[camera];
  PatchMeasurement& measurement = measurements_[index][camera];
  if (!sums.is_inside) return;
  const float n = float(patch::kSamples), spread = sums.ii - sums.i * sums.i / n;
  measurement.is_visible = true;
  measurement.brightness = sums.i / (n * view.mean);
  measurement.ncc = spread > 1e-3f ? sums.ti / std::sqrt(spread * view.contrast) : 0.f;
  measurement.expected_ncc = std::max(0.f, 1.f - noise_share_ / view.contrast);
}

void LevelMeasurement::displace(int camera, std::size_t k) {
  const auto& sums = sums_[camera][k];
  const int index = placed_[camera].placements[k].patch;
  const PatchView& view = level_.patches[index].view[camera];
  PatchMeasurement& measurement = measurements_[index][camera];
  const float gain = sums.ti / view.contrast;
  if (!measurement.is_visible || measurement.ncc < 0.1f || gain < 0.05f) return;
  Eigen::Vector2f pull(sums.ui, sums.vi);
  if (level_.level == 0) {
    auto& slopes = light_slopes_[camera];
    slopes.resize(level_.patches.size(), Eigen::Vector2f::Zero());
    if (rounds_ <= kLightSteps)
      slopes[index] = lightSlope(model_.neighbours[index], measurements_, index, camera);
    pull -= measurement.brightness * view.ramp.cast<float>() * slopes[index];
  }
  measurement.displacement = view.structure_inverse.cast<float>() * pull / -gain;
}

}  // namespace facenav::head_tracking
