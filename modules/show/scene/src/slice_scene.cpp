#include "facenav/scene/slice_scene.h"

#include <algorithm>
#include <cmath>

#include "paint.h"

namespace facenav::scene {
namespace {

/// Samples the mask at each pixel, trilinear, so that its contour at 0.5 is smooth.
std::vector<float> sampleSmooth(const volume::Mask& mask, const volume::SlicePlane& plane) {
  std::vector<float> values(std::size_t(plane.width) * plane.height);
  const Eigen::Affine3d voxel_from_mri = mask.grid.mri_from_voxel.inverse();
  const Eigen::Vector3d start = voxel_from_mri * plane.origin.mm;
  const Eigen::Vector3d du = voxel_from_mri.linear() * plane.right.v * plane.spacing_mm;
  const Eigen::Vector3d dv = voxel_from_mri.linear() * plane.down.v * plane.spacing_mm;
  for (int v = 0; v < plane.height; ++v)
    for (int u = 0; u < plane.width; ++u) {
      const Eigen::Vector3d p = start + u * du + v * dv;
      const Eigen::Vector3d low = p.array().floor();
      const int i = int(low.x()), j = int(low.y()), k = int(low.z());
      float sum = 0.f;
      for (int corner = 0; corner < 8; ++corner) {
        const int a = corner & 1, b = (corner >> 1) & 1, c = corner >> 2;
        if (!mask.grid.contains(i + a, j + b, k + c) || !mask.at(i + a, j + b, k + c)) continue;
        const Eigen::Vector3d f = p - low;
        sum += float((a ? f.x() : 1 - f.x()) * (b ? f.y() : 1 - f.y()) * (c ? f.z() : 1 - f.z()));
      }
      values[std::size_t(v) * plane.width + u] = sum;
    }
  return values;
}

void paintContour(RgbImage& image, const std::vector<float>& mask, const palette::Rgb& colour) {
  const int w = image.width_px, h = image.height_px;
  const auto at = [&](int u, int v) { return mask[std::size_t(v) * w + u]; };
  for (int v = 1; v + 1 < h; ++v)
    for (int u = 1; u + 1 < w; ++u) {
      const float gx = 0.5f * (at(u + 1, v) - at(u - 1, v)), gy = 0.5f * (at(u, v + 1) - at(u, v - 1));
      const float slope = std::hypot(gx, gy);
      if (slope < 1e-4f) continue;
      const double distance_px = std::abs(at(u, v) - 0.5f) / slope;
      blend(image, u, v, colour, std::clamp(1.5 - distance_px, 0.0, 1.0));
    }
}

void paintMri(RgbImage& image, const SliceScene& scene, const volume::SlicePlane& plane) {
  const auto values = volume::sampleSlice(*scene.mri, plane);
  const double scale = 255.0 / std::max(1e-9, scene.white - scene.black);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto grey = std::uint8_t(std::clamp((values[i] - scene.black) * scale, 0.0, 255.0));
    image.rgb[3 * i] = image.rgb[3 * i + 1] = image.rgb[3 * i + 2] = grey;
  }
}

void paintTargets(RgbImage& image, const SliceScene& scene, const volume::SlicePlane& plane) {
  for (const auto& target : scene.targets) {
    const Eigen::Vector3d cortex = plane.toPixel(target.cortex_point);
    const Eigen::Vector3d scalp = plane.toPixel(target.scalp_point);
    const bool is_active = target.name == scene.active_target;
    const palette::Rgb& colour = is_active ? palette::kOrange : palette::kMuted;
    if (std::abs(cortex.z()) < 8.0 || std::abs(scalp.z()) < 8.0)
      line(image, scalp.head<2>(), cortex.head<2>(), colour, 1.2, 0.8);
    if (std::abs(cortex.z()) < 4.0) circle(image, cortex.head<2>(), 4.0 / plane.spacing_mm, colour, 1.8, 1.0);
  }
}

/// Draws the crosshair if it lies on the plane, as it always does on the anatomical ones.
void paintCrosshair(RgbImage& image, const Point<Mri>& at, const volume::SlicePlane& plane) {
  constexpr double kOnPlane_mm = 1.0;
  const Eigen::Vector3d on_plane = plane.toPixel(at);
  if (std::abs(on_plane.z()) > kOnPlane_mm) return;
  const Eigen::Vector2d p = on_plane.head<2>();
  const double gap = 8.0, w = image.width_px, h = image.height_px;
  for (double side : {-1.0, 1.0}) {
    line(image, {p.x() + side * gap, p.y()}, {side < 0 ? 0 : w, p.y()}, palette::kBlue, 1.0, 0.75);
    line(image, {p.x(), p.y() + side * gap}, {p.x(), side < 0 ? 0 : h}, palette::kBlue, 1.0, 0.75);
  }
}

}  // namespace

char sideLetter(const Direction<Mri>& direction) {
  Eigen::Index axis = 0;
  direction.v.cwiseAbs().maxCoeff(&axis);
  return direction.v[axis] > 0 ? "RAS"[axis] : "LPI"[axis];
}

std::string sideLetters(const Direction<Mri>& direction) {
  const double least = std::sin(M_PI / 8);  // half way from one letter to two
  std::vector<int> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(),
            [&](int a, int b) { return std::abs(direction.v[a]) > std::abs(direction.v[b]); });
  std::string letters(1, sideLetter(direction));
  const int second = axes[1];
  if (std::abs(direction.v[second]) > least)
    letters += direction.v[second] > 0 ? "RAS"[second] : "LPI"[second];
  return letters;
}

SlicePosition positionOf(const volume::SlicePlane& plane) {
  const Eigen::Vector3d normal = plane.right.v.cross(plane.down.v);
  const double along_mm = plane.origin.mm.dot(normal);
  return {sideLetter(Direction<Mri>(along_mm < 0 ? Eigen::Vector3d(-normal) : normal)), std::abs(along_mm)};
}

std::optional<float> SliceScene::valueAtCrosshair() const {
  return mri && crosshair ? volume::valueAt(*mri, *crosshair) : std::nullopt;
}

void setUsualWindow(SliceScene& scene) {
  if (!scene.mri) return;
  scene.black = volume::percentile(*scene.mri, 0.005);
  scene.white = std::max<double>(scene.black + 1e-3, volume::percentile(*scene.mri, 0.995));
}

RgbImage SliceScene::picture(const volume::SlicePlane& plane) const {
  RgbImage image(plane.width, plane.height);
  if (mri) paintMri(image, *this, plane);
  for (const auto& overlay : overlays) paintOverlay(image, overlay, plane);
  for (const auto& contour : contours)
    if (contour.mask) paintContour(image, sampleSmooth(*contour.mask, plane), contour.colour);
  for (const auto& p_mm : points.points_mm) {
    const Eigen::Vector3d p = plane.toPixel(Point<Mri>(p_mm));
    if (std::abs(p.z()) <= point_reach_mm) circle(image, p.head<2>(), 0.3, point_colour, 1.6, 0.95);
  }
  paintTargets(image, *this, plane);
  if (crosshair) paintCrosshair(image, *crosshair, plane);
  if (has_letters) paintSideLetters(image, plane, text_scale, 1.0);
  return image;
}

}  // namespace facenav::scene
