#include "skin_detail.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/settings_in_force.h"
#include "facenav/head_tracking/skin_detail_limits.h"
#include "patch_filters.h"
#include "search_kernel.h"

namespace facenav::head_tracking {
namespace {

using patch::kSamples;

constexpr int kFirst = 20,
              kBand = 34;  // patterns of the detail; smoother ones contain light and what all faces share
// Variance of the sensor's noise in these patterns, relative to that before the blur: bicubic sampling in the
// key frame, bilinear now, mean over all sub-pixel places (the patterns' own unit includes sampling errors).
constexpr float kNoiseThen = 0.29f, kNoiseNow = 0.22f;

using Patches = Eigen::Matrix<float, kSamples, Eigen::Dynamic>;
// One column per patch. The rows of patterns beyond kBand are zero.
using Coefficients = Eigen::Matrix<float, search::Expansion::kPatterns, Eigen::Dynamic>;
static_assert(kBand <= search::Expansion::kPatterns);

const Eigen::Matrix<float, search::Expansion::kPatterns, kSamples>& detailPatterns() {
  static const auto patterns = [] {
    Eigen::Matrix<float, search::Expansion::kPatterns, kSamples> chosen;
    chosen.setZero();
    chosen.topRows<kBand>() = patternsByFineness().middleRows<kBand>(kFirst);
    return chosen;
  }();
  return patterns;
}

Coefficients coefficientsOf(const Patches& patches, Eigen::Index count) {
  Coefficients coefficients(search::Expansion::kPatterns, count);
  search::Expansion task;
  task.patterns = detailPatterns().data(), task.values = patches.data();
  task.length = kSamples, task.count = int(count);
  task.to = coefficients.data();
  search::kernel().expand(task);
  return coefficients;
}

// Grey values at a placed patch's samples; false if one lies outside.
bool sample(const BlurredImage& image, const PatchLevel& level, const std::array<float, 12>& pose,
            const patch::Placement& at, float* grey) {
  const std::size_t first = std::size_t(at.patch) * kSamples;
  search::Sampling task;
  task.pixels = image.pixels.ptr<std::uint16_t>(), task.stride = int(image.pixels.step1());
  task.left = image.origin.x, task.top = image.origin.y;
  task.width = image.pixels.cols, task.height = image.pixels.rows;
  task.x = &level.x[first], task.y = &level.y[first], task.z = &level.z[first];
  task.count = kSamples;
  std::copy(pose.begin(), pose.end(), task.camera_T_head);
  std::copy(std::begin(at.d), std::end(at.d), task.d);
  std::copy(std::begin(at.offset), std::end(at.offset), task.offset);
  task.to = grey;
  return search::kernel().sample(task);
}

DetailAgreement compared(const Coefficients& then, const Coefficients& now, float noise_then,
                         float noise_now) {
  DetailAgreement sum;
  for (Eigen::Index i = 0; i < then.cols(); ++i) {
    const auto a = then.col(i), b = now.col(i);
    const float aa = a.squaredNorm(), bb = b.squaredNorm();
    const float signal =
        std::max(0.f, 1.f - kBand * noise_then / aa) * std::max(0.f, 1.f - kBand * noise_now / bb);
    if (!(signal > 0)) continue;
    sum.product += std::sqrt(signal) * a.dot(b) / std::sqrt(aa * bb);
    sum.expected += signal;
  }
  return sum;
}

}  // namespace

double DetailAgreement::value() const { return product / std::max(1e-9, expected); }
double DetailAgreement::sigma() const { return 1.0 / std::sqrt(kBand * std::max(1e-9, expected)); }

DetailAgreement detailAgreement(const cameras::StereoRig& rig, const PatchModel& model,
                                const PatchLevel& finest, const std::array<ImagePyramid, 2>& now,
                                const PoseFit& fit, const PatchShare& share) {
  const auto plainly_else = float(settingsOf<SkinDetailLimits>().detail_plainly_else);
  const auto most = Eigen::Index(2 * (finest.patches.size() / share.every + 1));
  Patches then_grey(kSamples, most), now_grey(kSamples, most);
  Eigen::Index count = 0;
  for (int c = 0; c < 2; ++c) {
    if (now[c].level[0].pixels.empty()) continue;
    const Eigen::Isometry3d camera_T_head = c == 0 ? fit.motion : rig.right_T_left.isometry() * fit.motion;
    const auto in_float = floatsOf(camera_T_head);
    for (const auto& at : place(finest, c == 0 ? rig.left : rig.right, c, camera_T_head, share).placements) {
      const PatchMeasurement& measurement = fit.measurements[std::size_t(at.patch)][c];
      if (!measurement.is_visible || measurement.ncc < plainly_else * measurement.expected_ncc) continue;
      if (!sample(now[c].level[0], finest, in_float, at, now_grey.col(count).data())) continue;
      then_grey.col(count++) = Eigen::Map<const Eigen::Matrix<float, kSamples, 1>>(
          &finest.appearance[c].grey[std::size_t(at.patch) * kSamples]);
    }
  }
  now_grey.leftCols(count).rowwise() -= now_grey.leftCols(count).colwise().mean().eval();
  const float noise = float(model.noise_grey * model.noise_grey);
  return compared(coefficientsOf(then_grey, count), coefficientsOf(now_grey, count), kNoiseThen * noise,
                  kNoiseNow * noise);
}

DetailAgreement detailOfBothCameras(const PatchModel& model) {
  const PatchLevel& finest = model.level[0];
  std::array<Patches, 2> grey;
  for (auto& one : grey) one.resize(kSamples, finest.patches.size());
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < finest.patches.size(); ++i) {
    if (!finest.patches[i].view[0].is_usable || !finest.patches[i].view[1].is_usable) continue;
    for (int c = 0; c < 2; ++c)
      grey[c].col(count) =
          Eigen::Map<const Eigen::Matrix<float, kSamples, 1>>(&finest.appearance[c].grey[i * kSamples]);
    ++count;
  }
  const float noise = kNoiseThen * float(model.noise_grey * model.noise_grey);
  return compared(coefficientsOf(grey[0], count), coefficientsOf(grey[1], count), noise, noise);
}

SkinIdentity identityOfSkin(const DetailAgreement& seen, const DetailAgreement& of_both_cameras) {
  const SkinDetailLimits& limits = settingsOf<SkinDetailLimits>();
  const double agreed =
      std::clamp(of_both_cameras.value(), limits.detail_least_agreed, limits.detail_most_agreed);
  const double decides = limits.detail_decides * agreed, margin = limits.detail_sigmas * seen.sigma();
  if (seen.value() - margin > decides) return SkinIdentity::patient;
  if (seen.value() + margin < decides) return SkinIdentity::other_person;
  return SkinIdentity::undecided;
}

}  // namespace facenav::head_tracking
