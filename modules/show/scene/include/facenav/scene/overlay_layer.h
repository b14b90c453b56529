#pragma once
// OverlayLayer: overlays in the 3-D scene. Maps and masks are drawn on the brain's surface, meshes and tracts
// at their own positions. World must be Mri (ViewFrame::head_fixed).

#include <memory>
#include <vector>

#include "facenav/scene/navigation_scene.h"
#include "facenav/scene/overlay.h"

namespace facenav::scene {

/// Largest number of lines in 3-D; more are thinned evenly. Chosen for a machine without a graphics card.
/// Slices draw all.
constexpr std::size_t kMostLinesIn3d = 10000;

class OverlayLayer {
 public:
  /// Adds the layer to `scene`, which must outlive it.
  explicit OverlayLayer(NavigationScene& scene);
  ~OverlayLayer();
  OverlayLayer(const OverlayLayer&) = delete;
  OverlayLayer& operator=(const OverlayLayer&) = delete;

  /// Sets the overlays. `brain`: the surface that maps are drawn on; null: they are not drawn.
  void set(const std::vector<Overlay>& overlays, const surface::TriangleMesh* brain);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
