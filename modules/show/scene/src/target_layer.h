#pragma once
// TargetLayer: all targets of the case in the scene; the active one is coloured. Private to scene.

#include <optional>
#include <vector>

#include "actors.h"

namespace facenav::scene {

class TargetLayer {
 public:
  /// Builds the layer. `on_top`: renderer for parts that the head must not hide.
  TargetLayer(vtkRenderer* renderer, vtkRenderer* on_top, vtkLinearTransform* head)
      : renderer_(renderer), on_top_(on_top), head_(head) {}

  void set(const std::vector<guidance::Target>& targets, const std::string& active);
  const std::optional<guidance::Target>& active() const { return active_; }
  void setVisible(bool is_visible);
  /// Colours the active target: blue on target, otherwise orange. Lost poses make it grey, like all other
  /// targets.
  void setColours(bool is_grey, bool is_on_target);

 private:
  vtkRenderer *renderer_, *on_top_;
  vtkLinearTransform* head_;
  std::vector<TargetActors> targets_;
  std::size_t active_index_ = 0;
  std::optional<guidance::Target> active_;
};

}  // namespace facenav::scene
