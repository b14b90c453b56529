#pragma once
// CortexPicture: the brain's true surface, ready to be drawn: with the MRI at any peel depth, or coloured by
// its distance from the phi-theta model. Created on a worker thread, drawn by NavigationScene.

#include "facenav/core/task_monitor.h"
#include "facenav/scene/palette.h"
#include "facenav/surface/detailed_cortex.h"

namespace facenav::scene {

constexpr int kMostPeel_mm = 40;

struct CortexPicture {
  surface::DetailedCortex cortex;
  surface::PeelTexture peel;
  surface::TriangleMesh coarse_mesh;  // larger triangles, for a moving view (NavigationScene::setQuick)
  surface::PeelTexture coarse_peel;
  std::vector<float> coarse_distance_mm;
  surface::SurfaceDistance distance;  // summary over the vertices
  double full_mm = 2.0;               // distance at the end of the colour scale
};

/// Makes the picture in some seconds. `brain`: mask whose hull defines depth 0. Throws Cancelled.
CortexPicture makeCortexPicture(const volume::Volume& mri, const volume::Mask& brain,
                                surface::DetailedCortex cortex, TaskMonitor& monitor);

/// End of the colour scale, mm: the 95th percentile of the distance, rounded up to whole millimetres.
double distanceScale_mm(const surface::SurfaceDistance& distance);
/// Colour of a signed distance: orange outside, blue inside, white at 0, full colour at `full_mm`.
palette::Rgb distanceColour(double signed_mm, double full_mm);

}  // namespace facenav::scene
