#include "shell/linked_views.h"

#include <QApplication>
#include <QGridLayout>
#include <QLabel>
#include <QShortcut>
#include <QVBoxLayout>

#include "shell/appearance.h"

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
  scene_box_ = new QWidget(this);
  scene_column_ = new QVBoxLayout(scene_box_);
  scene_column_->setContentsMargins(0, 0, 0, 0);
  scene_title_ = new QLabel(tr("true cortex, coloured by its distance from the model"), scene_box_);
  scene_title_->setObjectName("muted");
  scene_title_->hide();
  scene_column_->setSpacing(4);
  scene_column_->addWidget(scene_title_);
  scene_column_->addWidget(scene_view_, 1);
  grid->addWidget(scene_box_, 1, 1);
  for (int i = 0; i < 2; ++i) grid->setRowStretch(i, 1), grid->setColumnStretch(i, 1);
  whenTextScales(this, [this] {
    if (!slice_scene_) return;
    slice_scene_->text_scale = sized(100) / 100.0;
    refreshSlices();
  });
  for (auto* view : slices_) {
    connect(view, &SliceView::crosshairMoved, this, [this](double x, double y, double z) {
      setCrosshair({x, y, z});
    });
    connect(view, &SliceView::chosen, this,
            [this](double x, double y, double z) { emit chosen(x, y, z, false); });
    connect(view, &SliceView::windowChanged, this, [this] { refreshSlices(); });
    connect(view, &SliceView::resetWanted, this, &LinkedViews::resetSlices);
  }
  auto* reset = new QShortcut(Qt::Key_R, this);
  reset->setWhatsThis(tr("the slices as they were at first: whole, usual brightness"));
  connect(reset, &QShortcut::activated, this, &LinkedViews::resetSlices);
  connect(scene_view_, &SceneView::placeWanted, this, [this](double x, double y, double z) {
    setCrosshair({x, y, z});
  });
  connect(scene_view_, &SceneView::picked, this, [this](double x, double y, double z, bool is_brain) {
    setCrosshair({x, y, z});
    emit chosen(x, y, z, !is_brain);
  });
}

void LinkedViews::addCoilSlices() {
  for (const auto cut : {scene::CoilCut::along_handle, scene::CoilCut::across_handle}) {
    auto* view = new CoilSliceView(cut, this);
    coil_slices_.push_back(view);
    connect(view, &CoilSliceView::crosshairMoved, this, [this](double x, double y, double z) {
      setCrosshair({x, y, z});
    });
    connect(view, &CoilSliceView::chosen, this,
            [this](double x, double y, double z) { emit chosen(x, y, z, false); });
    connect(view, &CoilSliceView::windowChanged, this, [this] { refreshSlices(); });
  }
  arrange();
}

/// Lays out the views of Plan in six columns and three rows: the slices below, the 3-D view large above them,
/// beside it the model's view and the slices along the coil, where they are shown.
void LinkedViews::arrange() {
  if (coil_slices_.empty()) return;
  constexpr int kColumns = 6, kRows = 3, kOfSlice = 2;
  auto* grid = static_cast<QGridLayout*>(layout());
  for (int i = 0; i < kColumns; ++i) grid->setColumnStretch(i, 1);
  for (int i = 0; i < kRows; ++i) grid->setRowStretch(i, 1);
  for (int i = 0; i < 3; ++i) grid->addWidget(slices_[std::size_t(i)], kRows - 1, kOfSlice * i, 1, kOfSlice);
  for (int i = 0; i < 2; ++i)
    grid->addWidget(coil_slices_[std::size_t(i)], i, kColumns - kOfSlice, 1, kOfSlice);
  const bool is_beside = model_box_ && !model_box_->isHidden();
  const int room = are_coil_slices_shown_ ? kColumns - kOfSlice : kColumns;
  const int model = is_beside ? room / 2 : 0;
  if (is_beside) grid->addWidget(model_box_, 0, 0, kRows - 1, model);
  grid->addWidget(scene_box_, 0, model, kRows - 1, room - model);
}

void LinkedViews::setCoil(const std::optional<scene::SlicedCoil>& coil, const QString& words) {
  for (auto* view : coil_slices_) view->setCoil(coil, words);
}

void LinkedViews::setOverlays(const std::vector<scene::Overlay>& overlays) {
  if (!slice_scene_) return;
  slice_scene_->overlays = overlays;
  refreshSlices();
}

void LinkedViews::setCoilSlicesShown(bool are_shown) {
  are_coil_slices_shown_ = are_shown;
  for (auto* view : coil_slices_) view->setVisible(are_shown);
  arrange();
}

void LinkedViews::show(const LoadedCase& loaded) {
  slice_scene_ = std::make_shared<scene::SliceScene>();
  slice_scene_->text_scale = sized(100) / 100.0;
  slice_scene_->mri = loaded.mri;
  scene::setUsualWindow(*slice_scene_);
  contours_ = {{loaded.head_mask, scene::palette::kOrange}};
  if (loaded.brain_mask) contours_.push_back({loaded.brain_mask, scene::palette::kBlue});
  slice_scene_->contours = contours_;
  slice_scene_->crosshair = loaded.brain ? loaded.brain->map.centre : loaded.mri->grid.centre();
  for (auto* view : slices_) view->setScene(slice_scene_);
  for (auto* view : coil_slices_) view->setScene(slice_scene_);
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

/// Makes the model view, beside the 3-D view.
void LinkedViews::makeModelView() {
  model_box_ = new QWidget(this);
  auto* column = new QVBoxLayout(model_box_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* title = new QLabel(tr("\u03c6\u2013\u03b8 model"), model_box_);
  title->setObjectName("muted");
  model_view_ = new SceneView(model_box_);
  model_view_->shareCamera(*scene_view_);
  column->addWidget(title);
  column->addWidget(model_view_, 1);
  model_foot_ = new QLabel(tr("turn either view, both follow"), model_box_);
  model_foot_->setObjectName("muted");
  model_foot_->setAlignment(Qt::AlignCenter);
  column->addWidget(model_foot_);
  connect(scene_view_, &SceneView::drawn, model_view_, [this] {
    if (QApplication::mouseButtons() == Qt::NoButton)
      model_view_->refreshMoving();  // during a drag shareCamera() does this
  });
}

void LinkedViews::showModelBeside(const LoadedCase* loaded) {
  const bool is_beside = loaded && loaded->brain;
  if (is_beside == (model_box_ && model_box_->isVisibleTo(this)) && (!is_beside || beside_ == loaded->brain))
    return;
  if (!model_view_) makeModelView();
  scene::SceneLayers layers;
  layers.scalp = !is_beside;
  scene_view_->scene().setLayers(layers);
  model_view_->scene().setLayers(layers);
  if (is_beside && beside_ != loaded->brain) model_view_->show(*loaded);
  if (is_beside) beside_ = loaded->brain;
  if (footer_) model_foot_->setFixedHeight(footer_->height());  // makes both views the same size
  scene_title_->setVisible(is_beside);
  model_box_->setVisible(is_beside);
  arrange();
}

void LinkedViews::setSceneFooter(QWidget* footer) {
  footer_ = footer;
  scene_column_->addWidget(footer);
}

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

void LinkedViews::resetSlices() {
  if (!slice_scene_) return;
  scene::setUsualWindow(*slice_scene_);
  for (auto* view : slices_) view->reset();
  for (auto* view : coil_slices_) view->reset();
}

void LinkedViews::refreshSlices() {
  for (auto* view : slices_) view->refresh();
  for (auto* view : coil_slices_) view->refresh();
}

}  // namespace facenav::ui
