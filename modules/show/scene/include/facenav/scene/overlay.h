#pragma once
// Overlay: something of another program shown over the MRI, on slices and in 3-D: a statistical map, a mask,
// a surface, tracts. Everything is in Mri already. Exactly one of its contents is set.

#include <memory>
#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/scene/palette.h"
#include "facenav/surface/tract_files.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/slice_plane.h"

namespace facenav::scene {

/// Tracts with the box of each line, so that a slice looks at few of them.
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
  double threshold = 0, full = 1;        // of a map: where its colours begin and end, both signs
  palette::Rgb colour{0.25, 0.9, 0.45};  // of mask and mesh; tracts show their direction
};

/// Positive values from dark red to yellow, negative ones from dark blue to pale cyan, lighter throughout.
/// Beyond `full` as there. `value` of either sign.
palette::Rgb mapColour(double value, double threshold, double full);
/// Red: left-right, green: front-back, blue: up-down, of either sense.
palette::Rgb directionColour(const Eigen::Vector3f& direction);

/// Draws over an MRI on `plane`. Tracts: the parts within 1 mm of it. A mesh: its cut.
void paintOverlay(RgbImage& image, const Overlay& overlay, const volume::SlicePlane& plane);

/// The map's value of the largest size within 4 mm under each vertex (against its normal): what a cortex
/// shows of a map. The depth was chosen: about the thickness of the cortex.
std::vector<float> valuesUnder(const surface::TriangleMesh& surface, const volume::Volume& map);

}  // namespace facenav::scene
