#include "lighting.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace facenav::room {
namespace {

constexpr double kProjectorBlur_px = 0.45;
constexpr double kSheen = 0.25;  // peak radiance of the lobe for gloss 1, in units of the lamp's light
constexpr double kGlint = 40.0;  // of wet skin: saturates the image where it mirrors a lamp

/// x^16: approximates the highlight of slightly moist skin.
double shine(double x) {
  x *= x, x *= x, x *= x;
  return x * x;
}

/// Blinn-Phong lobe of the oil film on skin, x^48: sharper than the dull shine of normal skin, much weaker
/// than wet skin. Chosen by eye on renderings beside photographs, not fitted.
double sheen(double cosine) {
  const double dull = shine(std::max(0.0, cosine));
  return dull * dull * dull;
}

float bilinear(const cv::Mat& image, double x, double y) {
  const int column = int(std::floor(x)), row = int(std::floor(y));
  if (column < 0 || row < 0 || column + 1 >= image.cols || row + 1 >= image.rows) return 0.f;
  const float fx = float(x - column), fy = float(y - row);
  const float* top = image.ptr<float>(row) + column;
  const float* bottom = image.ptr<float>(row + 1) + column;
  return (1 - fy) * ((1 - fx) * top[0] + fx * top[1]) + fy * ((1 - fx) * bottom[0] + fx * bottom[1]);
}

}  // namespace

LightMeter::LightMeter(const Lighting& lighting, const RayScene& scene) : lighting_(lighting), scene_(scene) {
  if (!lighting.projector) return;
  lighting.projector->pattern.convertTo(pattern_, CV_32F, 1.0 / 255.0);
  cv::GaussianBlur(pattern_, pattern_, {}, kProjectorBlur_px);
  projector_mm_ = lighting.projector->projector_T_world.inverse().translation();
}

LightMeter::Falling LightMeter::falling(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal,
                                        const Eigen::Vector3d& to_eye,
                                        const std::optional<Eigen::Vector3d>& relief_normal) const {
  Falling light;
  // Ambient light comes mainly from above and from the front.
  light.diffuse = float(lighting_.ambient * (0.75 + 0.25 * normal.dot(lighting_.up)));
  for (const Lamp& lamp : lighting_.lamps) {
    const Eigen::Vector3d to_lamp_mm = lamp.place_mm - p_mm;
    const double distance_mm = to_lamp_mm.norm(), cosine = normal.dot(to_lamp_mm) / distance_mm;
    if (cosine <= 0.0 || (lighting_.has_lamp_shadows && scene_.isBlocked(p_mm, lamp.place_mm))) continue;
    const double fall = lamp.intensity * lamp.reference_mm * lamp.reference_mm / (distance_mm * distance_mm);
    light.diffuse += float(fall * cosine);
    const Eigen::Vector3d half = (to_lamp_mm / distance_mm + to_eye).normalized();
    const double dull = shine(std::max(0.0, normal.dot(half)));
    light.highlight += float(fall * (dull + lighting_.wetness * kGlint * dull * dull * dull * dull));
    if (relief_normal) light.sheen += float(fall * sheen(relief_normal->dot(half)));
  }
  light.sheen *= float(kSheen * lighting_.gloss);
  light.sees_projector =
      lighting_.projector && normal.dot(projector_mm_ - p_mm) > 0.0 && !scene_.isBlocked(p_mm, projector_mm_);
  return light;
}

float LightMeter::dots(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal) const {
  const DotProjector& projector = *lighting_.projector;
  const Eigen::Vector3d p = projector.projector_T_world * p_mm;
  if (p.z() <= 0.0) return 0.f;
  const float dot = bilinear(pattern_, projector.focal_px * p.x() / p.z() + 0.5 * (pattern_.cols - 1),
                             projector.focal_px * p.y() / p.z() + 0.5 * (pattern_.rows - 1));
  const double cosine = normal.dot((projector_mm_ - p_mm).normalized());
  return float(dot * projector.intensity * projector.reference_mm * projector.reference_mm / p.squaredNorm() *
               std::max(0.0, cosine));
}

}  // namespace facenav::room
