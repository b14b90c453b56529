#include "facenav/scene/coil_slices.h"

#include <algorithm>
#include <cmath>

#include "paint.h"

namespace facenav::scene {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kZoomedAbout_mm = 40;   // depth under the contact face, about that of the cortex
constexpr double kLettersFromTop = 2.6;  // letter heights: below a window's line of text
constexpr double kHandle_mm = 110, kHandleThick_mm = 9, kTick_mm = 10;

/// Axis of Coil along the image's rows.
Vector3d rowOf(CoilCut cut) {
  return cut == CoilCut::along_handle ? Vector3d(Vector3d::UnitY()) : Vector3d(-Vector3d::UnitX());
}

/// Extent of the plate's outline on the slice: least and largest position along the image's rows, mm.
std::optional<std::pair<double, double>> plateOnSlice(const guidance::CoilPlate& plate, CoilCut cut) {
  const Vector3d row = rowOf(cut);
  const Vector2d along = row.head<2>(), across(-along.y(), along.x());
  std::vector<double> crossings;
  const std::size_t n = plate.outline_mm.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d &a = plate.outline_mm[i], &b = plate.outline_mm[(i + 1) % n];
    const double da = a.dot(across), db = b.dot(across);
    if ((da < 0) == (db < 0)) continue;
    crossings.push_back((a + da / (da - db) * (b - a)).dot(along));
  }
  if (crossings.empty()) return std::nullopt;
  const auto [low, high] = std::minmax_element(crossings.begin(), crossings.end());
  return std::pair(*low, *high);
}

/// Draws on the slice in the coil's own millimetres: x along the image's rows, y into the head.
struct CoilPen {
  RgbImage& image;
  const volume::SlicePlane& plane;
  Vector2d origin_px;

  Vector2d at(double row_mm, double depth_mm) const {
    return origin_px + Vector2d(row_mm, depth_mm) / plane.spacing_mm;
  }
  void stroke(const Vector2d& a_mm, const Vector2d& b_mm, const palette::Rgb& colour, double width_px,
              double opacity) const {
    line(image, at(a_mm.x(), a_mm.y()), at(b_mm.x(), b_mm.y()), colour, width_px, opacity);
  }
};

void paintPlate(const CoilPen& pen, const guidance::CoilPlate& plate, CoilCut cut) {
  const auto ends = plateOnSlice(plate, cut);
  if (!ends) return;
  pen.stroke({ends->first, 0}, {ends->second, 0}, palette::kCoil, 3.0, 1.0);
  if (cut == CoilCut::across_handle) return;
  const double thick_px = kHandleThick_mm / pen.plane.spacing_mm;
  pen.stroke({-kHandle_mm, -kHandleThick_mm}, {ends->first, -kHandleThick_mm}, palette::kCoil, thick_px,
             0.45);
}

/// Draws the beam with a tick every centimetre, and the bound of the error beside it.
void paintBeam(const CoilPen& pen, const SlicedCoil& coil, const std::optional<double>& ring_depth_mm) {
  const double end_mm = 2 * kCoilSliceDepth_mm;  // ends outside the picture at any zoom
  pen.stroke({0, 0}, {0, end_mm}, palette::kBlue, 1.4, 0.9);
  for (double depth_mm = kTick_mm; depth_mm < end_mm; depth_mm += kTick_mm)
    pen.stroke({-1.5, depth_mm}, {1.5, depth_mm}, palette::kBlue, 1.0, 0.9);
  if (!coil.bound95_mm || *coil.bound95_mm <= 0) return;
  for (const double side : {-1.0, 1.0})
    pen.stroke({side * *coil.bound95_mm, 0}, {side * *coil.bound95_mm, end_mm}, palette::kBlue, 1.0, 0.4);
  if (ring_depth_mm)
    circle(pen.image, pen.at(0, *ring_depth_mm), *coil.bound95_mm / pen.plane.spacing_mm, palette::kText, 1.4,
           0.95);
}

}  // namespace

volume::SlicePlane coilPlane(const RigidTransform<Mri, Coil>& mri_T_coil, CoilCut cut, int width_px,
                             int height_px, double zoom) {
  volume::SlicePlane plane;
  plane.width = std::max(16, width_px);
  plane.height = std::max(16, height_px);
  plane.right = Direction<Mri>(mri_T_coil.rotation() * rowOf(cut));
  plane.down = Direction<Mri>(Vector3d(mri_T_coil.rotation().col(2)));
  plane.spacing_mm = (kCoilSliceAbove_mm + kCoilSliceDepth_mm) / plane.height / zoom;
  const double above_mm = kZoomedAbout_mm - (kZoomedAbout_mm + kCoilSliceAbove_mm) / zoom;  // of the top row
  plane.origin = Point<Mri>(mri_T_coil.translation_mm() + above_mm * plane.down.v -
                            plane.spacing_mm * 0.5 * (plane.width - 1) * plane.right.v);
  return plane;
}

BeamPassing beamPassing(const RigidTransform<Mri, Coil>& mri_T_coil, const Point<Mri>& p) {
  const Vector3d in_coil = (mri_T_coil.inverse() * p).mm;
  return {in_coil.z(), in_coil.head<2>().norm()};
}

RgbImage coilSlicePicture(const SliceScene& scene, const SlicedCoil& coil, CoilCut cut,
                          const volume::SlicePlane& plane) {
  SliceScene shown = scene;
  shown.targets.clear();
  shown.has_letters = false;
  std::optional<double> ring_depth_mm;
  for (const auto& target : scene.targets)
    if (target.name == scene.active_target) {
      shown.targets.push_back(target);
      ring_depth_mm = beamPassing(coil.mri_T_coil, target.cortex_point).depth_mm;
    }
  RgbImage image = shown.picture(plane);
  const CoilPen pen{image, plane, plane.toPixel(Point<Mri>(coil.mri_T_coil.translation_mm())).head<2>()};
  paintPlate(pen, coil.plate, cut);
  paintBeam(pen, coil, ring_depth_mm);
  if (scene.has_letters) paintSideLetters(image, plane, scene.text_scale, kLettersFromTop);
  return image;
}

}  // namespace facenav::scene
