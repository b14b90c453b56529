#pragma once
// SliceScene: the content of a 2-D slice view as one picture: the MRI on a plane, contours of masks, targets,
// crosshair, orientation letters. Computed without a display, so reports use it too.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/guidance/target.h"
#include "facenav/scene/overlay.h"
#include "facenav/scene/palette.h"
#include "facenav/volume/slice_plane.h"

namespace facenav::scene {

struct SliceContour {
  std::shared_ptr<const volume::Mask> mask;
  palette::Rgb colour = palette::kBlue;
};

struct SliceScene {
  std::shared_ptr<const volume::Volume> mri;
  std::vector<Overlay> overlays;  // drawn over the MRI, in this order
  std::vector<SliceContour> contours;
  std::vector<guidance::Target> targets;
  std::string active_target;
  std::optional<Point<Mri>> crosshair;
  /// Points close to the plane, drawn as dots (a face cloud on the skin: figure 11).
  PointCloud<Mri> points;
  palette::Rgb point_colour{1.0, 0.25, 0.2};
  double point_reach_mm = 1.0;        // largest distance from the plane
  double black = 0.0, white = 255.0;  // window: the values shown black and white
  bool has_letters = true;
  double text_scale = 1.0;  // size of the letters, as a factor of the usual one

  /// The MRI's value under the crosshair; nullopt outside the MRI or without a crosshair.
  std::optional<float> valueAtCrosshair() const;
  /// Picture of the plane, plane.width x plane.height. Black if `mri` is null.
  RgbImage picture(const volume::SlicePlane& plane) const;
};

/// Sets a window that suits tissue: 0.5th to 99.5th percentile of the volume.
void setUsualWindow(SliceScene& scene);

/// Distance of a plane from the world's origin along its normal, and its side: S 12.3 mm.
struct SlicePosition {
  char side = 'S';
  double distance_mm = 0.0;
};
SlicePosition positionOf(const volume::SlicePlane& plane);

/// Letter (R L A P S I) of the patient's side that `direction` points to.
char sideLetter(const Direction<Mri>& direction);
/// Letter of the side, with a second one where the direction is oblique by more than 22.5 degrees: "LA".
std::string sideLetters(const Direction<Mri>& direction);

}  // namespace facenav::scene
