#pragma once
// Overlay: content of another program shown over the MRI, on slices and in 3-D: a statistical map, a mask, a
// surface, tracts. Everything is in Mri already. Exactly one of its contents is set.

#include <memory>
#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/scene/palette.h"
#include "facenav/surface/tract_files.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/slice_plane.h"

namespace facenav::scene {

/// Tracts with the box of each line, so that a slice tests few of them.
struct BoxedTracts {
  surface::TractLines tracts;
  std::vector<Eigen::Vector3f> low_mm, high_mm;  // one per line
};
BoxedTracts boxed(surface::TractLines tracts);

struct Overlay {
  std::string name;
  double opacity = 0.7;
  std::shared_ptr<const volume::Volume> map;   // shown where |value| >= threshold
  std::shared_ptr<const volume::Volume> mask;  // 0 to 1; shown from 0.5
  std::shared_ptr<const BoxedTracts> tracts;
  std::shared_ptr<const surface::TriangleMesh> mesh;
  double threshold = 0, full = 1;                   // map: start and end of its colours, for both signs
  bool is_strength = false;                         // map: never negative, in the colours of colour_scale.h
  std::shared_ptr<const volume::Mask> within = {};  // map: drawn in it alone; null: everywhere
  palette::Rgb colour{0.25, 0.9, 0.45};             // mask and mesh; tracts are coloured by direction
};

/// Colour of a map's value: positive from dark red to yellow, negative from dark blue to pale cyan, with
/// rising lightness; constant beyond `full`.
palette::Rgb mapColour(double value, double threshold, double full);
/// Colour of a direction, of either sense: red left-right, green front-back, blue up-down.
palette::Rgb directionColour(const Eigen::Vector3f& direction);

/// Draws over an MRI on `plane`. Tracts: the parts within 1 mm of it. A mesh: its cut.
void paintOverlay(RgbImage& image, const Overlay& overlay, const volume::SlicePlane& plane);

/// For each vertex, the map's value of the largest size within 4 mm under it (against its normal), about the
/// thickness of the cortex.
std::vector<float> valuesUnder(const surface::TriangleMesh& surface, const volume::Volume& map);

}  // namespace facenav::scene
