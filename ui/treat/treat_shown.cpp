// What the Treat page shows of the newest state, in words and figures.

#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>

#include "shell/appearance.h"
#include "shell/scene_view.h"
#include "treat/camera_row.h"
#include "treat/live_field_view.h"
#include "treat/live_slices.h"
#include "treat/treat_workspace.h"

namespace facenav::ui {
namespace {

constexpr const char* kSlicesShown = "treat/slices_shown";
constexpr const char* kSlicesInScene = "treat/slices_in_scene";

/// A button that stays pressed, as the settings keep it.
QPushButton* makeSwitch(const QString& text, const char* setting, bool usual, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName("tool");
  made->setCheckable(true);
  made->setChecked(QSettings().value(setting, usual).toBool());
  return made;
}

/// Pose of the second coil, to be drawn faintly; nothing if it or the head is lost.
std::optional<RigidTransform<Mri, frames::Target>> secondCoilOf(const session::NavigationState& state) {
  if (!state.second || !state.second->camera_T_coil || !state.camera_T_mri) return std::nullopt;
  return (state.camera_T_mri->inverse() * *state.second->camera_T_coil).reframe<Mri, frames::Target>();
}

}  // namespace

/// The newest state in words; before guidance: what is missing for it.
ReadOut TreatWorkspace::readOut(const session::NavigationState& state, bool was_started) const {
  ReadOut read_out = makeReadOut(state);
  if (presenter_.hasTracker()) {
    const bool is_there = presenter_.tracker().isConnected();
    read_out.cameras = {is_there ? tr("TRACKER on") : tr("TRACKER away"), presenter_.tracker().words(),
                        is_there ? Level::good : Level::lost};
  }
  const QString doing = presenter_.isRunning() ? QString() : presenter_.doingWords();
  if (was_started) {
    if (presenter_.isPaused()) return whilePaused(read_out, presenter_.pauseWords());
    if (!presenter_.hasEnded() || !state.failure.empty()) return read_out;
    read_out.instruction = doing.isEmpty() ? tr("RECORDING ENDED: end the session, or start again") : doing;
    read_out.level = Level::idle;
    return read_out;
  }
  const bool has_moved = hasMoved();
  read_out.instruction = !doing.isEmpty()         ? doing
                         : has_moved              ? tr("CAMERAS MOVED: repair them (step 1)")
                         : !model_.isOpen()       ? tr("NO CASE OPEN")
                         : !presenter_.mayTreat() ? tr("NOT SIGNED OFF")
                         : !presenter_.otherChoiceWords().isEmpty()
                             ? tr("CAMERAS CHANGED: open them (step 1)")
                         : presenter_.isAligned() ? tr("READY: start guidance")
                                                  : tr("NOT ALIGNED");
  read_out.level = Level::idle;
  read_out.timing.clear();
  if (!presenter_.hasTracker())
    read_out.cameras = {has_moved                   ? tr("CAMERAS moved")
                        : presenter_.hasRecording() ? tr("CAMERAS ready")
                                                    : tr("CAMERAS none"),
                        {},
                        has_moved ? Level::lost : Level::idle};
  read_out.face = {tr("FACE idle"), {}, Level::idle};
  read_out.coil = {tr("COIL idle"), {}, Level::idle};
  return read_out;
}

/// The newest state. In a pause nobody is guided: its guidance is blank, in every view.
std::shared_ptr<const session::NavigationState> TreatWorkspace::shownState() const {
  const auto state = presenter_.state();
  if (!presenter_.isPaused()) return state;
  auto paused = std::make_shared<session::NavigationState>(*state);
  paused->guidance = {};
  return paused;
}

void TreatWorkspace::makeViewSwitches(QWidget* bar) {
  show_slices_ = makeSwitch(tr("Slices"), kSlicesShown, true, bar);
  show_slices_->setToolTip(tr("the MRI along the coil's axis, along and across its handle (M)"));
  show_slices_->setShortcut(Qt::Key_M);
  slices_in_scene_ = makeSwitch(tr("in 3-D"), kSlicesInScene, false, bar);
  slices_in_scene_->setToolTip(tr("the same two slices in the 3-D scene, under the coil (Shift+M)"));
  slices_in_scene_->setShortcut(Qt::SHIFT + Qt::Key_M);
  show_field_ = new QPushButton(tr("Field"), bar);
  show_field_->setObjectName("tool");
  show_field_->setCheckable(true);
  show_field_->setChecked(field_.isOn());
  show_field_->setToolTip(
      tr("the electric field of the coil as it is held now, in colours on the brain, in V/m (E)"));
  show_field_->setShortcut(Qt::Key_E);
}

void TreatWorkspace::connectField() {
  connect(show_slices_, &QPushButton::toggled, this, [this](bool are_shown) {
    QSettings().setValue(kSlicesShown, are_shown);
    slices_->setVisible(are_shown && side_->currentIndex() == 0);
    signature_.clear();
  });
  connect(slices_in_scene_, &QPushButton::toggled, this, [this](bool are_shown) {
    QSettings().setValue(kSlicesInScene, are_shown);
    showSlicesInScene();
    signature_.clear();
  });
  connect(show_field_, &QPushButton::toggled, this, [this](bool is_shown) {
    field_.setOn(is_shown);
    field_view_->setVisible(is_shown && side_->currentIndex() == 0);
    signature_.clear();
  });
  connect(&field_, &LiveFieldPresenter::doseChanged, this, [this] { motor_.setDose(field_.doseInWords()); });
  connect(&motor_, &MotorPresenter::found, &field_, &LiveFieldPresenter::readChoices);
}

/// Colours the brain with the field that may be shown now; removes an older one.
void TreatWorkspace::drawField() {
  const auto picture = field_.picture();
  const std::int64_t frame = picture ? field_.shown()->frame : -1;
  if (frame < 0 && drawn_field_ < 0) return;
  drawn_field_ = frame;
  field_layer_->set(picture ? &*picture : nullptr, sized(100) / 100.0);
}

void TreatWorkspace::showSlicesInScene() {
  const bool are_shown = slices_in_scene_->isChecked() && model_.isOpen();
  scene_->scene().setCoilSlices(are_shown ? model_.current().mri : nullptr);
}

void TreatWorkspace::drawScene(const session::NavigationState& state, const ReadOut& read_out,
                               bool was_started) {
  auto& scene = scene_->scene();
  scene.setCoilGhost(was_started ? secondCoilOf(state) : std::nullopt);
  if (was_started) {
    scene.setHeadPose(state.camera_T_mri);
    scene.setCoilPose(state.camera_T_coil);
  } else {
    scene.setLive(false);
  }
  scene.setOnTarget(read_out.level == Level::good);
  const bool is_blank = read_out.level == Level::lost || read_out.level == Level::idle;
  scene.setBanner(was_started && is_blank ? read_out.instruction.toStdString() : std::string());
  drawField();
  was_started ? scene_->refreshMoving() : scene_->refresh();
}

/// Before guidance, shows the pictures of the alignment with the MRI's skin over them.
void TreatWorkspace::showPictures(const std::shared_ptr<const session::NavigationState>& state,
                                  bool was_started) {
  const auto& aligned = presenter_.alignmentPicture();
  if (was_started || !aligned || !presenter_.showsSkin()) return pictures_->follow(state);
  pictures_->showStill(aligned);
}

}  // namespace facenav::ui
