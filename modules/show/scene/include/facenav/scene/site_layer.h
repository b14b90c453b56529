#pragma once
// SiteLayer: named places on the scalp in the 3-D scene, such as the EEG sites of the 10-20 system. World
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
  /// `scene` must outlive it.
  explicit SiteLayer(NavigationScene& scene);
  ~SiteLayer();
  SiteLayer(const SiteLayer&) = delete;
  SiteLayer& operator=(const SiteLayer&) = delete;

  /// Empty: none. `text_scale`: of the names, as a factor of their usual size.
  void set(const std::vector<ScalpSite>& sites, double text_scale);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
