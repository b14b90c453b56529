#include "facenav/pictures/plan_picture.h"

#include <opencv2/imgproc.hpp>

#include "facenav/surface/closest_point.h"
#include "skin_canvas.h"

namespace facenav::pictures {
namespace {

using Eigen::Vector3d;

const cv::Scalar kLandmark(255, 150, 0), kSite(60, 230, 90), kTarget(90, 170, 255);

std::vector<SkinView> planViews() {
  const Vector3d r = Vector3d::UnitX(), f = Vector3d::UnitY(), u = Vector3d::UnitZ();
  return {{"left side", -f, -u, -r},
          {"front", -r, -u, f},
          {"above", r, -f, u},
          {"right side", f, -u, r},
          {"behind", r, -u, -f}};
}

/// True if the skin at the point faces the viewer.
bool isPlaceSeen(const SkinView& view, const surface::ClosestPoint& skin, const Point<Mri>& p) {
  constexpr double kLeast = 0.25;
  return skin.nearest(p).normal.v.dot(view.toward) > kLeast;
}

void drawPlaces(SkinCanvas& canvas, const surface::ClosestPoint& skin, const std::vector<NamedPlace>& places,
                const cv::Scalar& colour) {
  for (const NamedPlace& place : places)
    if (isPlaceSeen(canvas.view, skin, place.point)) drawDot(canvas, place.point.mm, place.name, colour);
}

/// A target and how it is drawn: a target of a grid is a dot, unless it is the active one.
struct DrawnTarget {
  bool is_whole, is_named;
};
DrawnTarget drawnAs(const guidance::Target& target, const std::string& active) {
  const bool is_active = target.name == active;
  return {!target.grid_place || is_active, active.empty() ? !target.grid_place : is_active};
}

/// Draws the plate's outline at the contact face, a line along the handle, and the axis' point on the skin.
void drawPlannedCoil(SkinCanvas& canvas, const guidance::Target& target, const guidance::CoilPlate& plate,
                     const DrawnTarget& drawn) {
  drawDot(canvas, target.scalp_point.mm, drawn.is_named ? target.name : std::string(), kTarget);
  if (!drawn.is_whole) return;
  constexpr double kDrawnHandle_mm = 110;
  const auto at = [&](double x, double y) {
    return canvas.at((target.mri_T_target * Point<frames::Target>(x, y, 0)).mm);
  };
  std::vector<cv::Point> outline;
  for (const auto& corner : plate.outline_mm) outline.push_back(at(corner.x(), corner.y()));
  cv::polylines(canvas.image, outline, true, kTarget, 1, cv::LINE_AA);
  cv::line(canvas.image, at(0, 0), at(0, -kDrawnHandle_mm), kTarget, 2, cv::LINE_AA);
}

}  // namespace

RgbImage drawPlan(const surface::ScalpSurface& scalp, const std::vector<NamedPlace>& landmarks,
                  const std::vector<NamedPlace>& sites, const std::vector<guidance::Target>& targets,
                  const guidance::CoilPlate& plate, const std::string& active) {
  const surface::ClosestPoint skin(scalp.mesh);
  std::vector<SkinCanvas> canvases;
  for (const SkinView& view : planViews()) {
    canvases.push_back(drawSkin(view, scalp.mesh));
    SkinCanvas& canvas = canvases.back();
    for (const auto& target : targets)
      if (isPlaceSeen(view, skin, target.scalp_point))
        drawPlannedCoil(canvas, target, plate, drawnAs(target, active));
    drawPlaces(canvas, skin, sites, kSite);
    drawPlaces(canvas, skin, landmarks, kLandmark);
    drawTitle(canvas);
  }
  return sideBySide(canvases);
}

}  // namespace facenav::pictures
