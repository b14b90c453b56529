#include "head_look.h"

#include <algorithm>
#include <cmath>

#include "eyelid.h"
#include "optics/noise_field.h"
#include "skin_texture.h"

namespace facenav::room {
namespace {

constexpr float kHairAlbedo = 0.07f;
// Relief of the skin for the sheen: pores and fine lines about 1 mm apart, slopes of 9 degrees (rms).
constexpr double kPore_mm = 0.6, kPoreSlope = 0.16;
// Redness of fair skin (red 1.33 times the grey, blue 0.67 times), higher where blood shows through;
// estimated from photographs, not fitted.
constexpr float kSkinRedness = 0.33f, kFlush = 0.05f, kLipRedness = 0.48f, kHairRedness = 0.25f;
constexpr double kFlush_mm = 5.0;

class HeadLook : public Look {
 public:
  HeadLook(const VirtualPatient& patient, const FaceShape& shape) : patient_(patient), shape_(shape) {}

  Reflectance at(const SurfacePoint& seen) const override {
    const SurfacePoint point = atRest(seen);
    const float hair = interpolated(patient_.hair, point);
    if (hair <= 0.02f) return skin(point);
    const Reflectance strands = hairAt(point.p_object_mm);
    if (hair >= 0.98f) return strands;
    const Reflectance bare = skin(point);
    return {bare.albedo + hair * (strands.albedo - bare.albedo), bare.gloss * (1.f - hair)};
  }

  float redness(const SurfacePoint& seen) const override {
    const SurfacePoint point = atRest(seen);
    const float hair = interpolated(patient_.hair, point);
    const float skin = kSkinRedness + kFlush * sharedNoise().at(point.p_object_mm, kFlush_mm);
    const float bare = skin + lips(point.p_object_mm) * (kLipRedness - skin);
    return bare + std::clamp(hair, 0.f, 1.f) * (kHairRedness - bare);
  }

  std::optional<Eigen::Vector3d> relief(const SurfacePoint& seen) const override {
    if (interpolated(patient_.hair, seen) > 0.5f) return {};
    const Eigen::Vector3d p_mm = atRest(seen).p_object_mm;
    const auto slope = [&p_mm](double away_mm) {
      return double(sharedNoise().at(p_mm + Eigen::Vector3d(away_mm, 0.0, 0.0), kPore_mm));
    };
    return kPoreSlope * Eigen::Vector3d(slope(200.0), 0.0, slope(400.0));
  }

 private:
  SurfacePoint atRest(SurfacePoint point) const {
    if (!shape_.isAtRest()) point.p_object_mm -= shape_.shift_mm(point.triangle, point.u, point.v);
    return point;
  }

  float interpolated(const std::vector<float>& values, const SurfacePoint& point) const {
    const Eigen::Vector3i& t = patient_.visible.triangles[point.triangle];
    return (1.f - point.u - point.v) * values[t[0]] + point.u * values[t[1]] + point.v * values[t[2]];
  }

  Reflectance skin(const SurfacePoint& point) const {
    const float pores = 1.f + patient_.pore_contrast * sharedNoise().at(point.p_object_mm, 0.5);
    const float albedo =
        (shape_.expression().blink > 0.0 ? blinking(point.p_object_mm)
                                         : patient_.texture->at(point.p_object_mm, shape_.lids())) *
        interpolated(patient_.tone, point) * pores * patient_.skin_brightness;
    if (shape_.expression().isNone()) return {albedo, 0.03f};
    const SkinPaint mouth = mouthPaint(shape_.expression(), point.p_object_mm, patient_.landmarks68_mm);
    return {albedo + mouth.share * (mouth.albedo - albedo), 0.03f};
  }

  float blinking(const Eigen::Vector3d& p_mm) const {
    const float open = patient_.texture->at(p_mm, shape_.lids());
    const SkinPaint lid = lidPaint(shape_.expression().blink, p_mm, patient_.landmarks68_mm);
    return open + lid.share * (lid.albedo - open);
  }

  /// Share 0..1 of the lips' red at a point; 0 for a patient without a face.
  float lips(const Eigen::Vector3d& p_mm) const {
    const auto& l = patient_.landmarks68_mm;
    if (l.empty()) return 0.f;
    const Eigen::Vector3d from_mm = p_mm - 0.5 * (l[51] + l[57]);
    const double half_width_mm = 0.5 * std::abs(l[48].x() - l[54].x()),
                 half_height_mm = 0.5 * std::abs(l[51].z() - l[57].z());
    const double away = std::hypot(from_mm.x() / half_width_mm, from_mm.z() / half_height_mm);
    return from_mm.y() > -30.0 ? float(std::clamp(4.0 * (1.1 - away), 0.0, 1.0)) : 0.f;
  }

  Reflectance hairAt(const Eigen::Vector3d& p_mm) const {
    // Strands run down and back, so the noise is stretched along them.
    const Eigen::Vector3d combed(p_mm.x(), 0.35 * p_mm.y(), 0.25 * p_mm.z());
    const float strands = sharedNoise().at(combed, 0.7), locks = sharedNoise().at(combed, 3.0);
    return {kHairAlbedo * std::max(0.2f, 1.f + 0.4f * strands + 0.3f * locks), 0.01f};
  }

  const VirtualPatient& patient_;
  const FaceShape& shape_;
};

class PlainLook : public Look {
 public:
  PlainLook(float albedo, float gloss, float grain) : albedo_(albedo), gloss_(gloss), grain_(grain) {}
  Reflectance at(const SurfacePoint& point) const override {
    if (grain_ <= 0.f) return {albedo_, gloss_};
    return {albedo_ * std::max(0.1f, 1.f + grain_ * sharedNoise().at(point.p_object_mm, 1.5)), gloss_};
  }

 private:
  float albedo_, gloss_, grain_;
};

}  // namespace

std::shared_ptr<const Look> makeHeadLook(const VirtualPatient& patient, const FaceShape& shape) {
  return std::make_shared<HeadLook>(patient, shape);
}

std::shared_ptr<const Look> makePlainLook(float albedo, float gloss, float grain) {
  return std::make_shared<PlainLook>(albedo, gloss, grain);
}

}  // namespace facenav::room
