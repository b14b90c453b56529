#include "plan/plan_workspace.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "plan/brain_look_panel.h"
#include "plan/field_view.h"
#include "plan/handle_panel.h"
#include "plan/map_legend.h"
#include "plan/place_panel.h"
#include "plan/target_list.h"
#include "plan/target_tools.h"
#include "shell/appearance.h"
#include "shell/linked_views.h"
#include "shell/narrow_label.h"
#include "shell/scroll_column.h"
#include "shell/shown_tools.h"

namespace facenav::ui {
namespace {

struct ArrowKey {
  int key;
  double x_mm, y_mm;
};
/// Steps along the coil's own axes. The coil is seen from above, so its +x points left.
constexpr ArrowKey kArrows[] = {
    {Qt::Key_Left, 1, 0}, {Qt::Key_Right, -1, 0}, {Qt::Key_Up, 0, 1}, {Qt::Key_Down, 0, -1}};
constexpr int kTwoLines_px = 34;
constexpr int kTargets_px = 150;              // of the list: four targets
constexpr double kFar_mm = 5, kTurn_deg = 5;  // a step with Shift; a turn with Ctrl

bool isView(const QWidget* widget) {
  return qobject_cast<const SliceView*>(widget) || qobject_cast<const CoilSliceView*>(widget) ||
         qobject_cast<const SceneView*>(widget);
}

}  // namespace

PlanWorkspace::PlanWorkspace(PlanPresenter& presenter, PlacePresenter& place, CortexPresenter& cortex,
                             CaseModel& model, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      place_(place),
      cortex_(cortex),
      model_(model),
      head_(new HeadPresenter(model, this)),
      overlays_(new OverlayPresenter(model, this)),
      field_(new FieldPresenter(presenter, model, this)),
      best_pose_(new BestPosePresenter(*field_, presenter, model, this)),
      views_(new LinkedViews(this)),
      overlay_layer_(std::make_unique<scene::OverlayLayer>(views_->sceneView().scene())),
      site_layer_(std::make_unique<scene::SiteLayer>(views_->sceneView().scene())),
      field_layer_(std::make_unique<scene::FieldLayer>(views_->sceneView().scene())) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 10, 10, 10);
  row->addWidget(views_, 1);
  views_->addCoilSlices();
  views_->setSceneFooter(new BrainLookPanel(cortex_, views_));
  row->addWidget(makeTargetsPanel());
  addKeys();
  connect(&model_, &CaseModel::opened, this, [this] {
    is_outdated_ = true;
    if (isVisible()) showCase();
  });
  connect(&model_, &CaseModel::brainChanged, this, [this] {
    is_outdated_ = true;
    if (isVisible()) showCase();
  });
  connect(&cortex_, &CortexPresenter::cortexChanged, this, [this] {
    if (!is_outdated_) takeCortex();
  });
  // Draws one image at a time, however fast the slider moves.
  connect(&cortex_, &CortexPresenter::changed, this, [this] {
    if (std::exchange(is_drawing_brain_, true)) return;
    QTimer::singleShot(0, this, [this] {
      is_drawing_brain_ = false;
      showBrain();
    });
  });
  connect(views_, &LinkedViews::crosshairMoved, this, [this] { place_panel_->show(views_->crosshair()); });
  connect(place_panel_, &PlacePanel::goTo, this, [this](double x, double y, double z) {
    views_->setCrosshair({x, y, z});
  });
  connect(place_panel_, &PlacePanel::targetWanted, this, [this](double x, double y, double z) {
    presenter_.addTargetNear({x, y, z});
  });
  connect(&presenter_, &PlanPresenter::changed, this, &PlanWorkspace::showPlan);
  connect(&presenter_, &PlanPresenter::refused, this, &PlanWorkspace::showFault);
  connect(head_, &HeadPresenter::refused, &presenter_, &PlanPresenter::refused);
  connect(head_, &HeadPresenter::changed, this, &PlanWorkspace::showSites);
  connect(&TextScaleNotice::instance(), &TextScaleNotice::changed, this, &PlanWorkspace::showSites);
  connect(overlays_, &OverlayPresenter::refused, &presenter_, &PlanPresenter::refused);
  connect(overlays_, &OverlayPresenter::changed, this, &PlanWorkspace::showOverlays);
  connect(views_, &LinkedViews::chosen, this, [this](double x, double y, double z, bool is_scalp) {
    is_scalp ? presenter_.addTargetAtScalp({x, y, z}) : presenter_.addTarget({x, y, z});
  });
}

TargetTools* PlanWorkspace::makeTools(QWidget* parent) {
  auto* tools = new TargetTools(presenter_, *head_, parent);
  connect(tools, &TargetTools::landmarkWanted, this,
          [this](surface::Landmark which) { head_->setLandmark(which, views_->crosshair()); });
  connect(tools, &TargetTools::goTo, this, [this](double x, double y, double z) {
    views_->setCrosshair({x, y, z});
  });
  connect(tools, &TargetTools::compareWith, this, [this](const QString& target) {
    compared_with_ = target;
    field_->setAgainst(target);
    showPlan();
  });
  return tools;
}

/// Makes the search field of the list and the note of the active target.
QWidget* PlanWorkspace::makeFields(QWidget* parent) {
  search_ = new QLineEdit(parent);
  search_->setAccessibleName(tr("search the targets"));
  search_->setPlaceholderText(tr("search"));
  search_->setToolTip(tr("shows the targets whose name or note holds these words"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, this, [this] { targets_->filter(search_->text()); });
  note_ = new QLineEdit(parent);
  note_->setAccessibleName(tr("note of the target"));
  note_->setPlaceholderText(tr("note"));
  note_->setToolTip(tr("note of the active target (Return)"));
  connect(note_, &QLineEdit::editingFinished, this, [this] {
    if (!note_->isModified()) return;
    note_->setModified(false);
    presenter_.setNote(note_->text());
  });
  return search_;
}

/// Shows why a step was refused, beside the targets, until the next step is done.
void PlanWorkspace::showFault(const QString& words) {
  fault_->setText(words);
  fault_->setVisible(!words.isEmpty());
  hint_->setVisible(words.isEmpty());  // one of both: the tools below stay where they are
}

void PlanWorkspace::showFields() {
  const auto* active = presenter_.active();
  note_->setEnabled(active && !active->is_locked);
  if (!note_->hasFocus()) note_->setText(active ? QString::fromStdString(active->note) : QString());
  const bool is_long = presenter_.plan().targets.size() > 5;
  search_->setVisible(is_long);
  if (!is_long) search_->clear();  // or targets would stay hidden without a reason in sight
}

/// Makes the row of the note and what undoes, redoes and deletes; in one row, as the list needs the height.
QHBoxLayout* PlanWorkspace::makeEdits(QWidget* parent) {
  auto* edit = new QHBoxLayout;
  edit->setSpacing(4);
  edit->addWidget(note_, 1);
  undo_ = new QPushButton(tr("Undo"), parent);
  redo_ = new QPushButton(tr("Redo"), parent);
  remove_ = new QPushButton(tr("Delete"), parent);
  undo_->setToolTip(tr("Ctrl+Z"));
  redo_->setToolTip(tr("Ctrl+Shift+Z"));
  remove_->setToolTip(tr("Del"));
  for (auto* button : {undo_, redo_, remove_}) {
    button->setObjectName("tool");
    edit->addWidget(button);
  }
  connect(undo_, &QPushButton::clicked, &presenter_, &PlanPresenter::undo);
  connect(redo_, &QPushButton::clicked, &presenter_, &PlanPresenter::redo);
  connect(remove_, &QPushButton::clicked, &presenter_, &PlanPresenter::removeActive);
  return edit;
}

QWidget* PlanWorkspace::makeTargetsPanel() {
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  auto* heading = new QLabel(tr("Targets"), panel);
  heading->setObjectName("heading");
  targets_ = new TargetList(presenter_, panel);
  detail_ = new QLabel(panel);
  makeNarrow(*detail_);
  detail_->setObjectName("figures_text");
  detail_->setToolTip(tr(
      "mm; the cortex's depth is measured from the scalp along the coil's axis; gap: between coil and skin, "
      "for hair"));
  hint_ =
      new QLabel(tr("Click the cortex, or double click a slice, for a target. Arrow keys move it."), panel);
  hint_->setObjectName("muted");
  fault_ = new QLabel(panel);
  fault_->setObjectName("fault");
  fault_->hide();
  column->addWidget(heading);
  offer_place_ = new QVBoxLayout;
  column->addLayout(offer_place_);
  for (auto* label : {hint_, fault_}) {
    makeNarrow(*label);
    whenTextScales(this, [label] { label->setMinimumHeight(sized(kTwoLines_px)); });
    column->addWidget(label);
  }
  auto* body = new QWidget(panel);
  auto* within = new QVBoxLayout(body);
  within->setContentsMargins(0, 0, 0, 0);
  whenTextScales(this, [this] { targets_->setMinimumHeight(sized(kTargets_px)); });
  targets_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // takes the remaining room
  within->addWidget(makeTools(body));
  shown_ = new ShownTools(presenter_, *overlays_, *field_, body);
  within->addWidget(shown_);
  within->addWidget(new MapLegend(*overlays_, body));
  within->addWidget(makeFieldView(body));
  within->addWidget(makeFields(body));
  within->addWidget(targets_, 1);
  within->addWidget(detail_);
  within->addLayout(makeEdits(panel));
  column->addWidget(new ScrollColumn(body, 300, panel), 1);
  column->addWidget(new HandlePanel(presenter_, panel));  // in sight however long the column is
  place_panel_ = new PlacePanel(place_, panel);
  column->addWidget(place_panel_);
  connect(shown_, &ShownTools::sitesShown, this, &PlanWorkspace::showSites);
  connect(shown_, &ShownTools::coilSlicesShown, views_, &LinkedViews::setCoilSlicesShown);
  views_->setCoilSlicesShown(shown_->showsCoilSlices());
  return panel;
}

QWidget* PlanWorkspace::makeFieldView(QWidget* parent) {
  connect(field_, &FieldPresenter::changed, this, &PlanWorkspace::showField);
  connect(field_, &FieldPresenter::reachChanged, this, &PlanWorkspace::showSlices);
  connect(&TextScaleNotice::instance(), &TextScaleNotice::changed, this, &PlanWorkspace::showField);
  return new FieldView(*field_, *best_pose_, parent);
}

void PlanWorkspace::showOverlays() {
  if (is_outdated_ || !model_.isOpen()) return;
  const auto shown = overlays_->shown();
  showSlices();
  const bool is_cortex = cortex_.look() != scene::BrainLook::model && cortex_.cortex();
  const auto& brain = model_.current().brain;
  std::shared_ptr<const surface::TriangleMesh> drawn;
  if (is_cortex)
    drawn = {cortex_.cortex(), &cortex_.cortex()->cortex.mesh};
  else if (brain)
    drawn = {brain, &brain->mesh};
  overlay_layer_->set(shown, drawn.get());
  field_->setDrawn(drawn);
  views_->sceneView().refresh();
}

/// Shows the overlays and the field on the slices.
void PlanWorkspace::showSlices() {
  if (is_outdated_ || !model_.isOpen()) return;
  auto shown = overlays_->shown();
  if (auto field = field_->sliceOverlay()) shown.push_back(std::move(*field));
  views_->setOverlays(shown);
}

void PlanWorkspace::showField() {
  const auto picture = field_->picture();
  field_layer_->set(picture ? &*picture : nullptr, sized(100) / 100.0);
  views_->sceneView().refresh();
}

void PlanWorkspace::showSites() {
  if (is_outdated_ || !model_.isOpen()) return;
  std::vector<scene::ScalpSite> sites;
  if (shown_->showsSites()) {
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);  // the first measures of a head take a second or two
    for (const auto& site : head_->sites()) sites.push_back({site.name, site.point});
    QGuiApplication::restoreOverrideCursor();
  }
  site_layer_->set(sites, sized(100) / 100.0);
  views_->sceneView().refresh();
}

void PlanWorkspace::addKeys() {
  const auto key = [this](const QKeySequence& keys, const QString& what, auto action) {
    auto* shortcut = new QShortcut(keys, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    shortcut->setWhatsThis(what);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  key(QKeySequence::Undo, tr("undo the last step of the plan"), [this] { presenter_.undo(); });
  key(QKeySequence::Redo, tr("redo the step that was undone"), [this] { presenter_.redo(); });
  key(Qt::CTRL + Qt::Key_G, tr("type coordinates to go to"), [this] { place_panel_->takeFocus(); });
  key(QKeySequence::Delete, tr("delete the active target"), [this] { presenter_.removeActive(); });
  for (const auto& arrow : kArrows) {  // wherever the focus is
    key(Qt::ALT + arrow.key, tr("move the target by 1 mm"),
        [this, arrow] { presenter_.nudgeActive(arrow.x_mm, arrow.y_mm); });
    key(Qt::ALT + Qt::SHIFT + arrow.key, tr("move the target by 5 mm"),
        [this, arrow] { presenter_.nudgeActive(kFar_mm * arrow.x_mm, kFar_mm * arrow.y_mm); });
  }
  const QString arrows =
      tr("arrows: move the target by 1 mm, with Shift 5 mm   Ctrl+left, Ctrl+right: turn it by 5\u00b0");
  for (auto* view : views_->findChildren<QWidget*>())
    if (isView(view)) view->setToolTip(view->toolTip() + "   " + arrows);
}

/// Moves or turns the active target by an arrow key. Returns false for any other key.
bool PlanWorkspace::moveByKey(const QKeyEvent& event) {
  const auto held = event.modifiers() & ~Qt::KeypadModifier;
  for (const auto& arrow : kArrows) {
    if (event.key() != arrow.key) continue;
    if (held == Qt::ControlModifier && arrow.x_mm != 0)
      return presenter_.turnActive(-kTurn_deg * arrow.x_mm), true;
    if (held != Qt::NoModifier && held != Qt::ShiftModifier) return false;
    const double steps = held == Qt::ShiftModifier ? kFar_mm : 1;
    return presenter_.nudgeActive(steps * arrow.x_mm, steps * arrow.y_mm), true;
  }
  return false;
}

void PlanWorkspace::keyPressEvent(QKeyEvent* event) {
  if (!isView(window()->focusWidget()) || !moveByKey(*event)) QWidget::keyPressEvent(event);
}

void PlanWorkspace::showCase() {
  if (!is_outdated_ || !model_.isOpen()) return;
  is_outdated_ = false;
  views_->show(model_.current());
  shown_cortex_.reset();  // the new brain removes it from the scene
  views_->setMasksShown(false);
  takeCortex();
  showBrain();
  showPlan();
  showOverlays();
  showSites();
  if (const auto* target = presenter_.active()) views_->setCrosshair(target->cortex_point);
  views_->sceneView().scene().setView(scene::ViewPreset::target);
}

void PlanWorkspace::takeCortex() {
  auto& scene = views_->sceneView().scene();
  if (shown_cortex_ == cortex_.cortex()) return;
  scene.setCortex(cortex_.cortex());
  shown_cortex_ = cortex_.cortex();
  showOverlays();
}

void PlanWorkspace::showBrain() {
  auto& view = views_->sceneView();
  const bool is_peeling = std::exchange(shown_peel_mm_, cortex_.peel_mm()) != cortex_.peel_mm();
  const bool is_beside = cortex_.isBesideModel() && cortex_.cortex() && model_.isOpen();
  views_->showModelBeside(is_beside ? &model_.current() : nullptr);
  if (std::exchange(shown_look_, cortex_.look()) != cortex_.look()) showOverlays();
  view.scene().setBrainLook(cortex_.look());
  view.scene().setPeelDepth(cortex_.peel_mm());
  is_peeling ? view.refreshPeeling() : view.refreshMoving();
}

void PlanWorkspace::showEvent(QShowEvent*) {
  showCase();
  field_->setInSight(true);
}

void PlanWorkspace::stopBuilding() { field_->fluid().cancel(); }

void PlanWorkspace::hideEvent(QHideEvent*) { field_->setInSight(false); }

}  // namespace facenav::ui
