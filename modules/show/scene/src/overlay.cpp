#include "facenav/scene/overlay.h"

#include <algorithm>
#include <cmath>

#include "facenav/scene/colour_scale.h"
#include "paint.h"

namespace facenav::scene {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kTractReach_mm = 1.0;

palette::Rgb mix(const palette::Rgb& a, const palette::Rgb& b, double share) {
  palette::Rgb mixed;
  for (std::size_t c = 0; c < 3; ++c) mixed[c] = a[c] + share * (b[c] - a[c]);
  return mixed;
}

void paintMap(RgbImage& image, const Overlay& overlay, const volume::SlicePlane& plane) {
  const auto values = volume::sampleSlice(*overlay.map, plane);
  const auto within =
      overlay.within ? volume::sampleSlice(*overlay.within, plane) : std::vector<std::uint8_t>();
  for (int v = 0; v < plane.height; ++v)
    for (int u = 0; u < plane.width; ++u) {
      const std::size_t pixel = std::size_t(v) * plane.width + u;
      const double value = values[pixel];
      if (std::abs(value) < overlay.threshold || value == 0 || (overlay.within && !within[pixel])) continue;
      const auto colour = overlay.is_strength
                              ? sequentialColour(ColourRange{overlay.threshold, overlay.full}.shareOf(value))
                              : mapColour(value, overlay.threshold, overlay.full);
      blend(image, u, v, colour, overlay.opacity);
    }
}

void paintMask(RgbImage& image, const Overlay& overlay, const volume::SlicePlane& plane) {
  const auto values = volume::sampleSlice(*overlay.mask, plane);
  for (int v = 0; v < plane.height; ++v)
    for (int u = 0; u < plane.width; ++u)
      if (values[std::size_t(v) * plane.width + u] >= 0.5f)
        blend(image, u, v, overlay.colour, overlay.opacity);
}

/// True if the plane through `origin` passes near the box.
bool isNear(const Vector3f& low, const Vector3f& high, const Vector3f& origin, const Vector3f& normal) {
  const Vector3f centre = 0.5f * (low + high) - origin, half = 0.5f * (high - low);
  return std::abs(centre.dot(normal)) <= half.dot(normal.cwiseAbs()) + float(kTractReach_mm);
}

void paintTracts(RgbImage& image, const Overlay& overlay, const volume::SlicePlane& plane) {
  const auto& boxed = *overlay.tracts;
  const Vector3f origin = plane.origin.mm.cast<float>();
  const Vector3f normal = plane.right.v.cross(plane.down.v).cast<float>();
  const auto toPixel = [&](const Vector3f& p) { return plane.toPixel(Point<Mri>(p.cast<double>())); };
  for (std::size_t i = 0; i < boxed.tracts.lines(); ++i) {
    if (!isNear(boxed.low_mm[i], boxed.high_mm[i], origin, normal)) continue;
    for (std::size_t p = boxed.tracts.begin(i) + 1; p < boxed.tracts.ends[i]; ++p) {
      const Vector3f &a = boxed.tracts.points_mm[p - 1], &b = boxed.tracts.points_mm[p];
      const float da = (a - origin).dot(normal), db = (b - origin).dot(normal);
      if (std::min(std::abs(da), std::abs(db)) > kTractReach_mm && (da < 0) == (db < 0)) continue;
      line(image, toPixel(a).head<2>(), toPixel(b).head<2>(), directionColour(b - a), 1.2, overlay.opacity);
    }
  }
}

void paintMeshCut(RgbImage& image, const Overlay& overlay, const volume::SlicePlane& plane) {
  const auto& mesh = *overlay.mesh;
  std::vector<Vector3d> pixels;
  pixels.reserve(mesh.vertices_mm.size());
  for (const auto& v : mesh.vertices_mm) pixels.push_back(plane.toPixel(Point<Mri>(v)));
  for (const auto& t : mesh.triangles) {
    Eigen::Vector2d ends[3];
    int found = 0;
    for (int c = 0; c < 3; ++c) {
      const Vector3d &a = pixels[std::size_t(t[c])], &b = pixels[std::size_t(t[(c + 1) % 3])];
      if ((a.z() < 0) == (b.z() < 0)) continue;
      ends[found++] = (a + a.z() / (a.z() - b.z()) * (b - a)).head<2>();
    }
    if (found == 2) line(image, ends[0], ends[1], overlay.colour, 1.6, overlay.opacity);
  }
}

}  // namespace

BoxedTracts boxed(surface::TractLines tracts) {
  BoxedTracts all;
  for (std::size_t i = 0; i < tracts.lines(); ++i) {
    Vector3f low = Vector3f::Constant(1e30f), high = -low;
    for (std::size_t p = tracts.begin(i); p < tracts.ends[i]; ++p) {
      low = low.cwiseMin(tracts.points_mm[p]);
      high = high.cwiseMax(tracts.points_mm[p]);
    }
    all.low_mm.push_back(low);
    all.high_mm.push_back(high);
  }
  all.tracts = std::move(tracts);
  return all;
}

palette::Rgb mapColour(double value, double threshold, double full) {
  const double range = std::max(1e-12, full - threshold);
  const double share = std::clamp((std::abs(value) - threshold) / range, 0.0, 1.0);
  return value >= 0 ? (share < 0.5 ? mix({0.62, 0.07, 0.05}, {1.0, 0.50, 0.0}, 2 * share)
                                   : mix({1.0, 0.50, 0.0}, {1.0, 1.0, 0.55}, 2 * share - 1))
                    : (share < 0.5 ? mix({0.05, 0.15, 0.65}, {0.1, 0.55, 1.0}, 2 * share)
                                   : mix({0.1, 0.55, 1.0}, {0.75, 1.0, 1.0}, 2 * share - 1));
}

palette::Rgb directionColour(const Vector3f& direction) {
  const float length = direction.norm();
  if (!(length > 0)) return palette::kMuted;
  const Vector3f d = direction.cwiseAbs() / length;
  return {double(d.x()), double(d.y()), double(d.z())};
}

void paintOverlay(RgbImage& image, const Overlay& overlay, const volume::SlicePlane& plane) {
  if (overlay.map) paintMap(image, overlay, plane);
  if (overlay.mask) paintMask(image, overlay, plane);
  if (overlay.tracts) paintTracts(image, overlay, plane);
  if (overlay.mesh) paintMeshCut(image, overlay, plane);
}

std::vector<float> valuesUnder(const surface::TriangleMesh& surface, const volume::Volume& map) {
  constexpr double kDepth_mm = 4, kStep_mm = 1;
  const Eigen::Affine3d voxel_from_mri = map.grid.mri_from_voxel.inverse();
  std::vector<float> values(surface.vertices_mm.size(), 0.f);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (double depth_mm = 0; depth_mm <= kDepth_mm; depth_mm += kStep_mm) {
      const Vector3d p = surface.vertices_mm[i] - depth_mm * surface.normals[i];
      const float value = volume::sampleLinear(map, voxel_from_mri * p);
      if (std::abs(value) > std::abs(values[i])) values[i] = value;
    }
  return values;
}

}  // namespace facenav::scene
