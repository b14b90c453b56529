#pragma once
// Look: the reflectance of a surface. Albedo and gloss are functions of the point in the object's own frame,
// so the same skin shows the same pores in both cameras and in every pose.

#include <Eigen/Core>
#include <memory>
#include <optional>

namespace facenav::room {

struct Reflectance {
  float albedo = 0.5f;  // diffuse, 0..1, linear
  float gloss = 0.f;    // weight of the highlight
};

struct SurfacePoint {
  Eigen::Vector3d p_object_mm;
  int triangle = 0;
  float u = 0.f, v = 0.f;
};

class Look {
 public:
  virtual ~Look() = default;
  virtual Reflectance at(const SurfacePoint& point) const = 0;
  /// Colour, for colour cameras: red is (1 + redness) times the grey, blue (1 - redness) times, green equals
  /// the grey. Gloss has the lamps' colour.
  virtual float redness(const SurfacePoint&) const { return 0.f; }
  /// True if the albedo has printed edges; all its pixels are then sampled densely.
  virtual bool isPrinted() const { return false; }
  /// Slope of the fine relief (pores) that tilts the surface's normal for the sheen of `Lighting::gloss`, in
  /// the object's frame, unitless. nullopt if the surface has no sheen.
  virtual std::optional<Eigen::Vector3d> relief(const SurfacePoint&) const { return {}; }
};

/// Look of one tone with a fine grain.
std::shared_ptr<const Look> makePlainLook(float albedo, float gloss, float grain = 0.05f);

}  // namespace facenav::room
