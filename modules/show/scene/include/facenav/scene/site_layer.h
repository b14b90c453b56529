#pragma once
// SiteLayer: named points of the scalp in the 3-D scene, such as the EEG sites of the 10-20 system. World
// must be Mri (ViewFrame::head_fixed).

#include <memory>
#include <string>
#include <vector>

#include "facenav/scene/navigation_scene.h"

namespace facenav::scene {

struct ScalpSite {
  std::string name;
  Point<Mri> point;  // on the skin
};

class SiteLayer {
 public:
  /// Adds the layer to `scene`, which must outlive it.
  explicit SiteLayer(NavigationScene& scene);
  ~SiteLayer();
  SiteLayer(const SiteLayer&) = delete;
  SiteLayer& operator=(const SiteLayer&) = delete;

  /// Sets the sites; empty: none. `text_scale`: size of the names, as a factor of the usual one.
  void set(const std::vector<ScalpSite>& sites, double text_scale);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
