#pragma once
// CortexPicture: the brain's true surface ready to be drawn: with the MRI under it at any peel depth, and
// coloured by its distance from the phi-theta model. Made on a worker thread, drawn by NavigationScene.

#include "facenav/core/task_monitor.h"
#include "facenav/scene/palette.h"
#include "facenav/surface/detailed_cortex.h"

namespace facenav::scene {

constexpr int kMostPeel_mm = 40;

struct CortexPicture {
  surface::DetailedCortex cortex;
  surface::PeelTexture peel;
  surface::TriangleMesh coarse_mesh;  // larger triangles, for while it moves (NavigationScene::setQuick)
  surface::PeelTexture coarse_peel;
  std::vector<float> coarse_distance_mm;
  surface::SurfaceDistance distance;  // over the vertices
  double full_mm = 2.0;               // where the scale of the colour map ends
};

/// Seconds. `brain`: the mask whose hull depth is counted from. Throws Cancelled.
CortexPicture makeCortexPicture(const volume::Volume& mri, const volume::Mask& brain,
                                surface::DetailedCortex cortex, TaskMonitor& monitor);

/// Where the colour map's scale ends, mm: whole millimetres, beyond 95 of 100 places.
double distanceScale_mm(const surface::SurfaceDistance& distance);
/// Colour of a signed distance: orange outside, blue inside, white at 0, full at `full_mm`.
palette::Rgb distanceColour(double signed_mm, double full_mm);

}  // namespace facenav::scene
