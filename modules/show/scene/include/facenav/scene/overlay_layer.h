#pragma once
// OverlayLayer: overlays in the 3-D scene. Maps and masks lie on the brain's surface; meshes and tracts stand
// where they are. World must be Mri (ViewFrame::head_fixed).

#include <memory>
#include <vector>

#include "facenav/scene/navigation_scene.h"
#include "facenav/scene/overlay.h"

namespace facenav::scene {

/// More lines than this are thinned evenly in 3-D; slices draw all. Chosen for a machine without a graphics
/// card.
constexpr std::size_t kMostLinesIn3d = 10000;

class OverlayLayer {
 public:
  /// `scene` must outlive it.
  explicit OverlayLayer(NavigationScene& scene);
  ~OverlayLayer();
  OverlayLayer(const OverlayLayer&) = delete;
  OverlayLayer& operator=(const OverlayLayer&) = delete;

  /// `brain`: the surface that maps lie on; null: they are not drawn.
  void set(const std::vector<Overlay>& overlays, const surface::TriangleMesh* brain);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
