#pragma once
// PulseLayer: pulses in the 3-D scene: the coil's centre (disc on the scalp, stroke towards the handle) and
// the point where its axis met the cortex (ball), each in a colour of its own; and a heat map on the brain.
// World must be Mri (ViewFrame::head_fixed).

#include <memory>
#include <optional>
#include <vector>

#include "facenav/scene/colour_scale.h"
#include "facenav/scene/navigation_scene.h"

namespace facenav::scene {

struct PulseMark {
  RigidTransform<Mri, Coil> mri_T_coil;
  std::optional<Point<Mri>> on_cortex;
  palette::Rgb colour = palette::kBlue;
  bool is_excluded = false;  // small and grey
  bool is_chosen = false;    // larger, with a white rim
};

class PulseLayer {
 public:
  /// Adds the layer to `scene`, which must outlive it.
  explicit PulseLayer(NavigationScene& scene);
  ~PulseLayer();
  PulseLayer(const PulseLayer&) = delete;
  PulseLayer& operator=(const PulseLayer&) = delete;

  void set(const std::vector<PulseMark>& marks);
  /// Sets the heat map. `values`: one per vertex of `surface`; NaN: nothing is drawn there.
  void setHeat(const surface::TriangleMesh& surface, const std::vector<float>& values,
               const ColourRange& range);
  void clearHeat();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
