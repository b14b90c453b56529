#pragma once
// Lighting: lamps, ambient light and the dot projector, and the brightness of a surface point seen from an
// eye position. Linear light; 1 is a white sheet facing the main lamp.

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "look.h"
#include "ray_scene.h"

namespace facenav::room {

struct Lamp {
  Eigen::Vector3d place_mm;  // world
  double intensity = 1.0;    // irradiance at reference_mm
  double reference_mm = 1500.0;
};

struct DotProjector {
  Eigen::Isometry3d projector_T_world = Eigen::Isometry3d::Identity();  // axes as a camera's
  double focal_px = 1400.0;
  cv::Mat pattern;         // 8-bit; projected slightly out of focus
  double intensity = 2.6;  // irradiance of a full white pixel at reference_mm
  double reference_mm = 650.0;
};

struct Lighting {
  std::vector<Lamp> lamps;
  double ambient = 0.25;
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
  bool has_lamp_shadows = true;
  double wetness = 0.0;   // 0: normal skin; 1: sweat or ointment, with small hard highlights
  double gloss = 0.0;     // sheen of the skin's oil: 0 none, 1 shiny face; depends on the eye position
  double backdrop = 1.0;  // light on the wall, relative to full light
  std::optional<DotProjector> projector;
  bool has_colour = false;  // compute colours
};

class LightMeter {
 public:
  LightMeter(const Lighting& lighting, const RayScene& scene);

  /// Light that changes slowly over a pixel: lamps and ambient, with their shadows.
  struct Falling {
    float diffuse = 0.f, highlight = 0.f;
    float sheen = 0.f;  // of the oil on the skin; not scaled by the reflectance
    bool sees_projector = false;
  };
  /// Computes that light. `relief_normal`: normal of the surface with its fine relief, unit, world; nullopt:
  /// no sheen.
  Falling falling(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal, const Eigen::Vector3d& to_eye,
                  const std::optional<Eigen::Vector3d>& relief_normal = {}) const;
  /// Light of the dot pattern on a point that is visible from the projector.
  float dots(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal) const;

 private:
  const Lighting& lighting_;
  const RayScene& scene_;
  cv::Mat pattern_;  // float, blurred
  Eigen::Vector3d projector_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace facenav::room
