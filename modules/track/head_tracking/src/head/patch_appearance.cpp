#include "patch_appearance.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "patch_filters.h"

namespace facenav::head_tracking {
namespace {

using patch::kSamples;
using patch::kSide;

constexpr double kSamplingError_px = 0.05;  // error from sampling and from each view's own shading
constexpr double kUsualShading = 0.1;       // change of light that the filters are designed for
constexpr double kWorstSigma_px = 0.5;  // patches with a larger error in their best direction are left out
constexpr double kLeastDepthError_mm = 0.2;  // of the smoothed cloud on smooth, frontal skin
constexpr double kSurfaceReach_px = 5.5;     // margin round the patch for the surface fitted under it
constexpr double kSpreadPerRoughness = 0.2;  // rad of a normal per mm of roughness, over half a patch

// Grey value and its derivatives along x and y (differences over two pixels) by Catmull-Rom's bicubic kernel.
// All three share the same six row sums.
struct Sample {
  float grey = 0.f, d_u = 0.f, d_v = 0.f;
};

struct Taps {
  std::array<float, 6> value{}, slope{};  // at the pixels -2 .. 3

  explicit Taps(float t) {
    const std::array<float, 4> w = {0.5f * (-t + 2 * t * t - t * t * t),
                                    0.5f * (2 - 5 * t * t + 3 * t * t * t),
                                    0.5f * (t + 4 * t * t - 3 * t * t * t), 0.5f * (-t * t + t * t * t)};
    for (std::size_t k = 0; k < 4; ++k) {
      value[k + 1] = w[k];
      slope[k + 2] += 0.5f * w[k];
      slope[k] -= 0.5f * w[k];
    }
  }
};

Sample sampleAt(const cv::Mat1w& image, const Eigen::Vector2d& px) {
  const int ix = int(std::floor(px.x())), iy = int(std::floor(px.y()));
  const Taps x(float(px.x() - ix)), y(float(px.y() - iy));
  Sample sample;
  for (int j = 0; j < 6; ++j) {
    const std::uint16_t* row = image.ptr<std::uint16_t>(iy - 2 + j) + ix - 2;
    float value = 0, slope = 0;
    for (int k = 0; k < 6; ++k) value += x.value[k] * float(row[k]), slope += x.slope[k] * float(row[k]);
    sample.grey += y.value[j] * value;
    sample.d_u += y.value[j] * slope;
    sample.d_v += y.slope[j] * value;
  }
  constexpr float kGrey = 1.f / kGreyScale;
  return {kGrey * sample.grey, kGrey * sample.d_u, kGrey * sample.d_v};
}

bool isInside(const cv::Mat1w& image, const Eigen::Vector2d& px, double margin) {
  return px.x() >= margin && px.y() >= margin && px.x() < image.cols - 1 - margin &&
         px.y() < image.rows - 1 - margin;
}

double dot(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double(a[i]) * b[i];
  return sum;
}

double removeMean(std::vector<float>& values) {
  double mean = 0;
  for (float value : values) mean += value / double(values.size());
  for (float& value : values) value -= float(mean);
  return mean;
}

// First-order effect of light that changes across a patch: one side gets brighter.
std::array<std::vector<float>, 2> shadingRamps(const std::vector<float>& grey) {
  std::array<std::vector<float>, 2> ramps;
  for (int i = 0; i < kSamples; ++i) {
    ramps[0].push_back(grey[i] * (float(i % kSide) - 0.5f * (kSide - 1)));
    ramps[1].push_back(grey[i] * (float(i / kSide) - 0.5f * (kSide - 1)));
  }
  return ramps;
}

using Square = Eigen::Matrix<float, kSide, kSide, Eigen::RowMajor>;

// Correlation matrix along one axis of errors with unit variance; `by_lag`: correlation at each lag.
Square correlation(const std::array<double, kSide>& by_lag) {
  Square c;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) c(i, j) = float(by_lag[std::size_t(std::abs(i - j))]);
  return c;
}

const Square& shadingCorrelation() {  // smooth over some two pixels
  static const Square c = [] {
    std::array<double, kSide> by_lag;
    for (int lag = 0; lag < kSide; ++lag) by_lag[lag] = std::exp(-0.5 * std::pow(lag / kFineShading_px, 2));
    return correlation(by_lag);
  }();
  return c;
}

const Square& noiseCorrelationAt(int level) {
  static const Square finest = correlation(noiseCorrelation(0)), halved = correlation(noiseCorrelation(1));
  return level == 0 ? finest : halved;
}

// C * pattern, where C is the correlation over the whole patch.
std::vector<float> correlated(const std::vector<float>& pattern, const Square& c) {
  std::vector<float> result(kSamples);
  Eigen::Map<Square>(result.data()) =
      c.lazyProduct((Eigen::Map<const Square>(pattern.data()).lazyProduct(c)).eval());
  return result;
}

// Computes the response of the filters in `appearance` to noise, shading and light; `whole`: the derivatives
// themselves.
void weigh(PatchAppearance& appearance, const std::array<std::vector<float>, 2>& whole,
           const std::array<std::vector<float>, 2>& ramps, int level, double noise_grey) {
  const std::array<const std::vector<float>*, 2> d = {&appearance.d_u, &appearance.d_v};
  Eigen::Matrix2d structure, noise, shading;
  for (int b = 0; b < 2; ++b) {
    const auto noisy = correlated(*d[b], noiseCorrelationAt(level));
    const auto shaded = correlated(*d[b], shadingCorrelation());
    for (int a = 0; a < 2; ++a) {
      structure(a, b) = dot(*d[a], whole[b]);
      noise(a, b) = dot(*d[a], noisy);
      shading(a, b) = dot(*d[a], shaded);
      appearance.view.ramp(a, b) = dot(*d[a], ramps[b]);
    }
  }
  // Damped, so that flat skin gives no motion instead of a random one.
  const double least = 1e-3 * structure.trace() + 1e-6;
  const Eigen::Matrix2d inverse = (structure + least * Eigen::Matrix2d::Identity()).inverse();
  const double variance = 2.0 * noise_grey * noise_grey;  // noise of the key frame and of the current one
  appearance.view.structure_inverse = inverse;
  appearance.view.covariance = variance * inverse * noise * inverse.transpose() +
                               kSamplingError_px * kSamplingError_px * Eigen::Matrix2d::Identity();
  appearance.view.shading =
      appearance.view.mean * appearance.view.mean * inverse * shading * inverse.transpose();
  appearance.view.is_usable =
      appearance.view.covariance.inverse().trace() > 1.0 / (kWorstSigma_px * kWorstSigma_px);
}

// Mean angle between the normals near the patch's corners and the one at its centre.
double normalSpread(const PatchPoints& points) {
  double sum = 0;
  for (int v : {1, kSide - 2})
    for (int u : {1, kSide - 2}) {
      const auto* p = points.points_mm.data() + v * kSide + u;
      const Eigen::Vector3d normal = (p[kSide] - p[-kSide]).cross(p[1] - p[-1]).normalized();
      sum += std::acos(std::clamp(normal.dot(points.normal), -1.0, 1.0));
    }
  return sum / 4;
}

}  // namespace

std::optional<PatchPoints> pointsOf(const cameras::StereoRig& rig, const FaceSurface& surface,
                                    const Eigen::Vector2d& centre_px, int level) {
  const double scale = 1 << level, half = 0.5 * (kSide - 1);
  const auto local = surface.around(scale * centre_px, scale * (half + kSurfaceReach_px));
  if (!local) return std::nullopt;
  const auto lift = [&](const Eigen::Vector2d& px) -> Eigen::Vector3d {
    return cameras::undistort(rig.left, px).homogeneous() / local->inverseDepth(px);
  };
  PatchPoints points;
  for (int v = 0; v < kSide; ++v)
    for (int u = 0; u < kSide; ++u) {
      const Eigen::Vector2d px = scale * (centre_px + Eigen::Vector2d(u - half, v - half));
      if (!(local->inverseDepth(px) > 0)) return std::nullopt;
      points.points_mm.push_back(lift(px));
    }
  const Eigen::Vector2d c = scale * centre_px;
  points.centre_mm = lift(c);
  const Eigen::Vector3d across = lift(c + Eigen::Vector2d(scale, 0)) - lift(c - Eigen::Vector2d(scale, 0));
  const Eigen::Vector3d down = lift(c + Eigen::Vector2d(0, scale)) - lift(c - Eigen::Vector2d(0, scale));
  points.normal = down.cross(across).normalized();
  points.right_mm = 0.5 * across, points.down_mm = 0.5 * down;
  points.normal_spread_rad = normalSpread(points) + local->roughness_mm * kSpreadPerRoughness;
  const double facing = std::max(0.2, -points.normal.dot(points.centre_mm.normalized()));
  points.depth_sigma_mm = std::hypot(kLeastDepthError_mm, local->roughness_mm) / (facing * facing);
  return points;
}

PatchAppearance appearanceOf(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_head,
                             const BlurredImage& image, const PatchPoints& points, int level,
                             double noise_grey) {
  const double scale = 1 << level;
  const Eigen::Vector2d origin(image.origin.x, image.origin.y);
  PatchAppearance appearance;
  const Eigen::Vector3d centre_mm = camera_T_head * points.centre_mm;
  const double facing = -(camera_T_head.linear() * points.normal).dot(centre_mm.normalized());
  if (facing < kGrazing_cos) return appearance;
  for (auto* values : {&appearance.grey, &appearance.d_u, &appearance.d_v}) values->reserve(kSamples);
  for (const auto& p_mm : points.points_mm) {
    const Eigen::Vector2d px = cameras::project(camera, camera_T_head * p_mm) / scale - origin;
    if (!isInside(image.pixels, px, 3)) return appearance;
    const Sample sample = sampleAt(image.pixels, px);
    appearance.grey.push_back(sample.grey), appearance.d_u.push_back(sample.d_u),
        appearance.d_v.push_back(sample.d_v);
  }
  const auto whole_ramps = shadingRamps(appearance.grey);
  appearance.view.mean = float(removeMean(appearance.grey));
  appearance.view.contrast = float(dot(appearance.grey, appearance.grey));
  appearance.view.px = cameras::project(camera, centre_mm);
  appearance.view.ray = camera_T_head.linear().transpose() * centre_mm.normalized();
  if (appearance.view.contrast < 1e-3f || appearance.view.mean < 1.f) return appearance;
  for (auto* d : {&appearance.d_u, &appearance.d_v}) removeMean(*d);
  const std::array<std::vector<float>, 2> whole = {appearance.d_u, appearance.d_v};
  const double shading_grey = shadingSigma(kUsualShading, points.normal_spread_rad) * appearance.view.mean;
  auto filters =
      displacementFilters(appearance.grey, appearance.d_u, appearance.d_v, level, std::sqrt(2.0) * noise_grey,
                          shading_grey);  // noise of the key frame and of the current one
  appearance.d_u = std::move(filters[0]), appearance.d_v = std::move(filters[1]);
  weigh(appearance, whole, whole_ramps, level, noise_grey);
  return appearance;
}

void addJacobian(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_head,
                 const Eigen::Vector3d& patch_mm, const Eigen::Vector3d& centre_mm, int level,
                 PatchView& view) {
  Eigen::Matrix<double, 2, 3> d_p;
  cameras::project(camera, camera_T_head * patch_mm, d_p);
  const Eigen::Matrix<double, 2, 3> d_x = d_p * camera_T_head.linear() / double(1 << level);
  view.jacobian << d_x * -skew(patch_mm - centre_mm), d_x;
}

double noiseBeforeBlur(double noise_grey, int level) {
  return noise_grey * std::pow(0.5, std::max(0, level - 1));
}

double noiseShare(int level) {
  const double along = noiseCorrelation(level)[0];
  return along * along * std::pow(0.25, std::max(0, level - 1));
}

double noiseOf(const cv::Mat& grey) {
  constexpr int kBlock_px = 16;
  std::vector<double> sigmas;
  for (int y0 = 1; y0 + kBlock_px < grey.rows; y0 += kBlock_px)
    for (int x0 = 1; x0 + kBlock_px < grey.cols; x0 += kBlock_px) {
      double sum = 0;
      int clipped = 0;
      for (int y = y0; y < y0 + kBlock_px; ++y) {
        const std::uint8_t *a = grey.ptr(y - 1), *b = grey.ptr(y), *c = grey.ptr(y + 1);
        for (int x = x0; x < x0 + kBlock_px; ++x) {
          sum += std::abs(a[x - 1] + a[x + 1] + c[x - 1] + c[x + 1] -
                          2 * (a[x] + c[x] + b[x - 1] + b[x + 1]) + 4 * b[x]);
          clipped += b[x] <= 2 || b[x] >= 253;
        }
      }
      if (clipped < kBlock_px) sigmas.push_back(std::sqrt(M_PI / 2) / 6.0 * sum / (kBlock_px * kBlock_px));
    }
  if (sigmas.empty()) return 1.5;
  const auto fifth = sigmas.begin() + std::ptrdiff_t(sigmas.size() / 5);
  std::nth_element(sigmas.begin(), fifth, sigmas.end());
  return std::clamp(*fifth, 0.5, 8.0);  // quantisation alone gives 0.3
}

}  // namespace facenav::head_tracking
