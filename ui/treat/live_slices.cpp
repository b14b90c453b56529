#include "treat/live_slices.h"

#include <QVBoxLayout>

#include "shell/appearance.h"

namespace facenav::ui {

LiveSlices::LiveSlices(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  const scene::CoilCut cuts[2] = {scene::CoilCut::along_handle, scene::CoilCut::across_handle};
  for (std::size_t i = 0; i < 2; ++i) {
    views_[i] = new CoilSliceView(cuts[i], this);
    column->addWidget(views_[i], 1);
    connect(views_[i], &CoilSliceView::windowChanged, this, [this] {
      for (auto* view : views_) view->refresh();
    });
  }
  whenTextScales(this, [this] {
    if (!scene_) return;
    scene_->text_scale = sized(100) / 100.0;
    for (auto* view : views_) view->refresh();
  });
}

void LiveSlices::show(const LoadedCase& loaded) {
  plate_ = loaded.coil.plate;
  if (scene_ && scene_->mri == loaded.mri) return;  // only the plan has changed: window and zoom stay
  scene_ = std::make_shared<scene::SliceScene>();
  scene_->mri = loaded.mri;
  scene_->text_scale = sized(100) / 100.0;
  scene::setUsualWindow(*scene_);
  for (auto* view : views_) view->setScene(scene_);
}

void LiveSlices::follow(const session::NavigationState& state, const QString& words,
                        std::optional<double> bound95_mm) {
  std::optional<scene::SlicedCoil> coil;
  if (scene_ && state.camera_T_mri && state.camera_T_coil) {
    coil = scene::SlicedCoil{state.camera_T_mri.value().inverse() * state.camera_T_coil.value(), plate_,
                             bound95_mm};
    scene_->targets.clear();
    if (state.chosen) scene_->targets.push_back(state.chosen->target);
    scene_->active_target = state.target;
  }
  for (auto* view : views_) view->setCoil(coil, words);
}

}  // namespace facenav::ui
