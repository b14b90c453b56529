#include "views/linked_views.h"

#include <QGridLayout>
#include <QVBoxLayout>

namespace facenav::ui {

LinkedViews::LinkedViews(QWidget* parent) : QWidget(parent), scene_view_(new SceneView(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  const volume::Anatomical orientations[3] = {volume::Anatomical::axial, volume::Anatomical::coronal,
                                              volume::Anatomical::sagittal};
  for (int i = 0; i < 3; ++i) {
    slices_[std::size_t(i)] = new SliceView(orientations[i], this);
    grid->addWidget(slices_[std::size_t(i)], i / 2, i % 2);
  }
  scene_column_ = new QVBoxLayout;
  scene_column_->addWidget(scene_view_, 1);
  grid->addLayout(scene_column_, 1, 1);
  for (int i = 0; i < 2; ++i) grid->setRowStretch(i, 1), grid->setColumnStretch(i, 1);
  for (auto* view : slices_) {
    connect(view, &SliceView::crosshairMoved, this, [this](double x, double y, double z) {
      setCrosshair({x, y, z});
    });
    connect(view, &SliceView::chosen, this,
            [this](double x, double y, double z) { emit chosen(x, y, z, false); });
    connect(view, &SliceView::windowChanged, this, [this] { refreshSlices(); });
  }
  connect(scene_view_, &SceneView::picked, this, [this](double x, double y, double z, bool is_brain) {
    setCrosshair({x, y, z});
    emit chosen(x, y, z, !is_brain);
  });
}

void LinkedViews::show(const LoadedCase& loaded) {
  slice_scene_ = std::make_shared<scene::SliceScene>();
  slice_scene_->mri = loaded.mri;
  scene::setUsualWindow(*slice_scene_);
  contours_ = {{loaded.head_mask, scene::palette::kOrange}};
  if (loaded.brain_mask) contours_.push_back({loaded.brain_mask, scene::palette::kBlue});
  slice_scene_->contours = contours_;
  slice_scene_->crosshair = loaded.brain ? loaded.brain->map.centre : loaded.mri->grid.centre();
  for (auto* view : slices_) view->setScene(slice_scene_);
  scene_view_->show(loaded);
}

void LinkedViews::setTargets(const guidance::TreatmentPlan& plan, const std::string& active) {
  if (!slice_scene_) return;
  slice_scene_->targets = plan.targets;
  slice_scene_->active_target = active;
  scene_view_->scene().setTargets(plan.targets, active);
  refreshSlices();
}

void LinkedViews::setMasksShown(bool are_shown) {
  are_masks_shown_ = are_shown;
  if (!slice_scene_) return;
  slice_scene_->contours = are_shown ? contours_ : std::vector<scene::SliceContour>();
  refreshSlices();
}

void LinkedViews::setContours(const std::vector<scene::SliceContour>& contours) {
  contours_ = contours;
  setMasksShown(are_masks_shown_);
}

void LinkedViews::setBrain(const LoadedCase& loaded) {
  if (loaded.brain) scene_view_->scene().setBrain(*loaded.brain);
  scene_view_->refresh();
}

void LinkedViews::setBrain(const surface::BrainModel& brain) {
  scene_view_->scene().setBrain(brain);
  scene_view_->refresh();
}

void LinkedViews::setSceneFooter(QWidget* footer) { scene_column_->addWidget(footer); }

void LinkedViews::setTool(SliceTool* tool) {
  for (auto* view : slices_) view->setTool(tool);
}

Point<Mri> LinkedViews::crosshair() const {
  return slice_scene_ && slice_scene_->crosshair ? *slice_scene_->crosshair : Point<Mri>();
}

void LinkedViews::setCrosshair(const Point<Mri>& at) {
  if (!slice_scene_) return;
  slice_scene_->crosshair = at;
  scene_view_->scene().setSliceCentre(at);
  scene_view_->refresh();
  refreshSlices();
  emit crosshairMoved();
}

void LinkedViews::refreshSlices() {
  for (auto* view : slices_) view->refresh();
}

}  // namespace facenav::ui
