#include "skin_detail.h"

#include <algorithm>
#include <cmath>

#include "patch_filters.h"

namespace facenav::tracking {
namespace {

using patch::kSamples;

constexpr int kFirst = 20, kBand = 34;  // patterns of the detail; what is smoother is light's, and all faces'
// Variance of the sensor's noise in these, by that before the blur: sampled bicubically in the key frame,
// bilinearly now, mean over all places between pixels (the patterns' own unit counts sampling as noise, too).
constexpr float kNoiseThen = 0.29f, kNoiseNow = 0.22f;
constexpr float kPlainlyElse = 0.5f;  // of the correlation expected: a hand, a mask, hair
constexpr double kDecides = 0.62;     // of what both cameras agree on: halfway between own and others'
constexpr double kLeastAgreed = 0.73, kMostAgreed = 1.25;  // beyond: the noise is not what was taken
constexpr double kSure = 3.0;                              // standard errors

using Patches = Eigen::Matrix<float, kSamples, Eigen::Dynamic>;
using Coefficients = Eigen::Matrix<float, kBand, Eigen::Dynamic>;

Coefficients coefficientsOf(const Patches& patches) {
  return patternsByFineness().middleRows<kBand>(kFirst) * patches;
}

// Bilinear at a placed patch's samples; false where one lies outside.
bool sample(const BlurredImage& image, const PatchLevel& level, const float m[12], const patch::Placement& at,
            float* grey) {
  const std::size_t first = std::size_t(at.patch) * kSamples;
  const float *x = &level.x[first], *y = &level.y[first], *z = &level.z[first];
  const float left = at.offset[0] - float(image.origin.x), top = at.offset[1] - float(image.origin.y);
  std::array<float, kSamples> u, v;
  for (int k = 0; k < kSamples; ++k) {
    const float w = 1.f / (m[6] * x[k] + m[7] * y[k] + m[8] * z[k] + m[11]);
    const float nx = w * (m[0] * x[k] + m[1] * y[k] + m[2] * z[k] + m[9]),
                ny = w * (m[3] * x[k] + m[4] * y[k] + m[5] * z[k] + m[10]);
    u[std::size_t(k)] = at.d[0] * nx + at.d[1] * ny + left;
    v[std::size_t(k)] = at.d[2] * nx + at.d[3] * ny + top;
  }
  const float right = float(image.pixels.cols - 1), bottom = float(image.pixels.rows - 1);
  for (std::size_t k = 0; k < kSamples; ++k) {
    if (!(u[k] >= 0 && v[k] >= 0 && u[k] < right && v[k] < bottom)) return false;
    const int iu = int(u[k]), iv = int(v[k]);
    const float fu = u[k] - float(iu), fv = v[k] - float(iv);
    const std::uint16_t *a = image.pixels[iv] + iu, *b = image.pixels[iv + 1] + iu;
    const float upper = float(a[0]) + fu * (float(a[1]) - float(a[0])),
                lower = float(b[0]) + fu * (float(b[1]) - float(b[0]));
    grey[k] = (upper + fv * (lower - upper)) / kGreyScale;
  }
  return true;
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

DetailAgreement detailAgreement(const stereo::StereoRig& rig, const PatchModel& model,
                                const PatchLevel& finest, const std::array<ImagePyramid, 2>& now,
                                const PoseFit& fit, const PatchShare& share) {
  const auto most = Eigen::Index(2 * (finest.patches.size() / share.every + 1));
  Patches then_grey(kSamples, most), now_grey(kSamples, most);
  Eigen::Index count = 0;
  for (int c = 0; c < 2; ++c) {
    const Eigen::Isometry3d camera_T_head = c == 0 ? fit.motion : rig.right_T_left.isometry() * fit.motion;
    const auto in_float = floatsOf(camera_T_head);
    for (const auto& at : place(finest, c == 0 ? rig.left : rig.right, c, camera_T_head, share).placements) {
      const PatchSight& sight = fit.sights[std::size_t(at.patch)][c];
      if (!sight.is_visible || sight.ncc < kPlainlyElse * sight.expected_ncc) continue;
      if (!sample(now[c].level[0], finest, in_float.data(), at, now_grey.col(count).data())) continue;
      then_grey.col(count++) = Eigen::Map<const Eigen::Matrix<float, kSamples, 1>>(
          &finest.looks[c].grey[std::size_t(at.patch) * kSamples]);
    }
  }
  now_grey.leftCols(count).rowwise() -= now_grey.leftCols(count).colwise().mean().eval();
  const float noise = float(model.noise_grey * model.noise_grey);
  return compared(coefficientsOf(then_grey.leftCols(count)), coefficientsOf(now_grey.leftCols(count)),
                  kNoiseThen * noise, kNoiseNow * noise);
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
          Eigen::Map<const Eigen::Matrix<float, kSamples, 1>>(&finest.looks[c].grey[i * kSamples]);
    ++count;
  }
  const float noise = kNoiseThen * float(model.noise_grey * model.noise_grey);
  return compared(coefficientsOf(grey[0].leftCols(count)), coefficientsOf(grey[1].leftCols(count)), noise,
                  noise);
}

Whose whoseSkin(const DetailAgreement& seen, const DetailAgreement& of_both_cameras) {
  const double decides = kDecides * std::clamp(of_both_cameras.value(), kLeastAgreed, kMostAgreed);
  if (seen.value() - kSure * seen.sigma() > decides) return Whose::patients;
  if (seen.value() + kSure * seen.sigma() < decides) return Whose::anothers;
  return Whose::undecided;
}

}  // namespace facenav::tracking
