#include "skin_layer.h"

#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "coarse_mesh.h"
#include "image_bridge.h"

namespace facenav::scene {
namespace {

constexpr double kCoarse_mm = 4.0;

}  // namespace

void SkinLayer::set(const surface::TriangleMesh& scalp) {
  for (vtkActor* old : {fine_.Get(), coarse_.Get()})
    if (old) renderer_->RemoveActor(old);
  fine_ = makeScalpActor(toPolyData(scalp));
  coarse_ = makeScalpActor(toPolyData(coarsened(scalp, kCoarse_mm)));
  for (vtkActor* actor : {fine_.Get(), coarse_.Get()}) {
    actor->SetUserTransform(head_);
    renderer_->AddActor(actor);
  }
}

void SkinLayer::setLook(bool is_visible, bool is_quick, bool is_grey, double opacity) {
  for (vtkActor* actor : {fine_.Get(), coarse_.Get()}) {
    if (!actor) continue;
    actor->SetVisibility(is_visible && (actor == coarse_) == is_quick);
    setColour(actor, is_grey ? palette::kLost : palette::kSkin);
    actor->GetProperty()->SetOpacity(opacity * (is_grey ? 0.7 : 1.0));
  }
}

vtkActor* SkinLayer::shown() const {
  for (vtkActor* actor : {fine_.Get(), coarse_.Get()})
    if (actor && actor->GetVisibility()) return actor;
  return nullptr;
}

}  // namespace facenav::scene
