#pragma once
// FieldLayer: a coil's electric field on the brain in the 3-D scene: colours by strength, lines at 50, 75
// and 90 % of the maximum, and a dot with words at the maximum. World must be Mri (ViewFrame::head_fixed).

#include <memory>
#include <string>
#include <vector>

#include "facenav/scene/colour_scale.h"
#include "facenav/scene/navigation_scene.h"
#include "facenav/scene/overlay.h"

namespace facenav::scene {

/// The field on a drawn surface of the brain.
struct FieldPicture {
  std::shared_ptr<const surface::TriangleMesh> surface;
  std::vector<float> strength;  ///< at its vertices, V/m
  double peak = 0;              ///< maximum on the cortex, V/m
  Point<Mri> peak_place;
  std::string peak_words = {};
};

/// Colours of a field: from a fifth of its maximum; a weaker field is not coloured, so that the brain stays
/// visible.
ColourRange fieldColours(double peak);
/// The field for the slices, in the same colours: `strength` in V/m, drawn inside the brain.
Overlay fieldOverlay(std::shared_ptr<const volume::Volume> strength,
                     std::shared_ptr<const volume::Mask> brain, double peak);

class FieldLayer {
 public:
  /// Adds the layer to `scene`, which must outlive it.
  explicit FieldLayer(NavigationScene& scene);
  ~FieldLayer();
  FieldLayer(const FieldLayer&) = delete;
  FieldLayer& operator=(const FieldLayer&) = delete;

  /// Sets the field; null: none. `text_scale`: size of the words, as a factor of the usual one.
  void set(const FieldPicture* picture, double text_scale);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
