#include "target_layer.h"

#include <vtkRenderer.h>

namespace facenav::scene {

void TargetLayer::set(const std::vector<guidance::Target>& targets, const std::string& active) {
  for (auto& target : targets_)
    for (vtkActor* actor : target.all()) {
      renderer_->RemoveActor(actor);
      on_top_->RemoveActor(actor);
    }
  targets_.clear();
  active_.reset();
  for (const auto& target : targets) {
    const bool is_active = target.name == active;
    if (is_active) active_ = target, active_index_ = targets_.size();
    targets_.push_back(makeTargetActors(target, is_active));
    const TargetActors& actors = targets_.back();
    for (vtkActor* actor : actors.all()) actor->SetUserTransform(head_);
    renderer_->AddActor(actors.ring);
    renderer_->AddActor(actors.line);
    if (is_active) on_top_->AddActor(actors.ring_on_top);
    on_top_->AddActor(actors.cortex);
  }
}

void TargetLayer::setVisible(bool is_visible) {
  for (auto& target : targets_)
    for (vtkActor* actor : target.all()) actor->SetVisibility(is_visible);
}

void TargetLayer::setColours(bool is_grey, bool is_on_target) {
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const bool is_plain = is_grey || !active_ || i != active_index_;
    const palette::Rgb colour = is_plain ? palette::kLost : is_on_target ? palette::kBlue : palette::kOrange;
    for (vtkActor* actor : targets_[i].all()) setColour(actor, colour);
  }
}

}  // namespace facenav::scene
