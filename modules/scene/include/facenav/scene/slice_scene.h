#pragma once
// SliceScene: what a 2-D slice view shows: the MRI on a plane, contours of masks, targets, crosshair,
// orientation letters, as one picture. Computed, not rendered: needs no display, so that reports use it too.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/guidance/target.h"
#include "facenav/scene/palette.h"
#include "facenav/volume/slice_plane.h"

namespace facenav::scene {

struct SliceContour {
  std::shared_ptr<const volume::Mask> mask;
  palette::Rgb colour = palette::kBlue;
};

struct SliceScene {
  std::shared_ptr<const volume::Volume> mri;
  std::vector<SliceContour> contours;
  std::vector<guidance::Target> targets;
  std::string active_target;
  std::optional<Point<Mri>> crosshair;
  /// Points near the plane (a face cloud on the skin: figure 11), drawn as dots.
  PointCloud<Mri> points;
  palette::Rgb point_colour{1.0, 0.25, 0.2};
  double point_reach_mm = 1.0;        // drawn when this near to the plane
  double black = 0.0, white = 255.0;  // window: values shown black and white
  bool has_letters = true;

  /// The MRI's value under the crosshair; nothing outside the MRI or without a crosshair.
  std::optional<float> valueAtCrosshair() const;
  /// Picture of the plane, plane.width x plane.height. Black where `mri` is null.
  RgbImage picture(const volume::SlicePlane& plane) const;
};

/// Window that shows tissue well: 0.5th to 99.5th percentile of the volume.
void setUsualWindow(SliceScene& scene);

/// How far a plane lies from the world's origin, along its normal, and towards which side: S 12.3 mm.
struct SlicePosition {
  char side = 'S';
  double distance_mm = 0.0;
};
SlicePosition positionOf(const volume::SlicePlane& plane);

/// The letter (R L A P S I) of the patient's side towards which `direction` points.
char sideLetter(const Direction<Mri>& direction);

}  // namespace facenav::scene
