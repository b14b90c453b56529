#include "treat/treat_workspace.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>

#include "shell/appearance.h"
#include "shell/elided_label.h"
#include "shell/scene_view.h"
#include "shell/scroll_column.h"
#include "shell/users_words.h"
#include "shell/words_of_button.h"
#include "treat/camera_row.h"
#include "treat/cameras_panel.h"
#include "treat/end_panel.h"
#include "treat/live_field_view.h"
#include "treat/live_slices.h"
#include "treat/override_panel.h"
#include "treat/pause_panel.h"
#include "treat/person_question.h"
#include "treat/return_panel.h"
#include "treat/treat_side.h"

namespace facenav::ui {
namespace {

constexpr int kPageRefresh_ms = 33;

/// Words of the third step while it guides, after a stop, and before the start.
QStringList guideWords() {
  const QString open(QChar(0x25cb)), live(QChar(0x25cf));
  return {TreatWorkspace::tr("3 Guide %1  stop").arg(live), TreatWorkspace::tr("3 Guide %1  go on").arg(open),
          TreatWorkspace::tr("3 Guide %1  start").arg(open)};
}

}  // namespace

TreatWorkspace::TreatWorkspace(TreatPresenter& presenter, CaseModel& model, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      model_(model),
      motor_(presenter, model),
      return_(presenter, model),
      check_(presenter),
      tip_(presenter),
      projector_(presenter, model),
      field_(presenter, model),
      screens_(new SecondScreens(projector_, *this)),
      scene_(new SceneView(this)),
      field_layer_(std::make_unique<scene::FieldLayer>(scene_->scene())),
      field_view_(new LiveFieldView(field_, this)),
      pause_(new PausePanel(presenter, this)),
      slices_(new LiveSlices(this)),
      pictures_(new CameraRow(this)) {
  setObjectName("treat");  // the style sheet makes its text legible from two metres
  auto* row = new QHBoxLayout;
  auto* middle = new QVBoxLayout;
  auto* seen = new QHBoxLayout;
  seen->addWidget(scene_, 5);
  seen->addWidget(slices_, 3);
  middle->addLayout(seen, 3);
  middle->addWidget(field_view_);
  middle->addWidget(pictures_, 2);
  row->addLayout(middle, 3);
  row->addWidget(makeSide(), 2);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 10, 10, 10);
  column->addWidget(new OverridePanel(presenter_, model_, this));
  column->addWidget(new ReturnPanel(return_, this));
  column->addWidget(pause_);
  column->addWidget(new EndPanel(presenter_, this));
  column->addLayout(row, 1);
  column->addWidget(makeSteps());
  timer_.setInterval(kPageRefresh_ms);
  connect(&timer_, &QTimer::timeout, this, &TreatWorkspace::refresh);
  connect(&presenter_, &TreatPresenter::changed, this, &TreatWorkspace::showSteps);
  connect(&motor_, &MotorPresenter::refused, &presenter_, &TreatPresenter::refused);
  connect(&projector_, &ProjectorPresenter::refused, &presenter_, &TreatPresenter::refused);
  connect(&presenter_, &TreatPresenter::personUnclear, this, [this](const QString& why, bool then_start) {
    const auto asked = model_.current().store.folder();
    askForPerson(*this, model_.current().label.isEmpty() ? model_.current().id : model_.current().label, why,
                 [this, then_start, asked] {  // the answer is about this case alone
                   if (model_.current().store.folder() == asked) presenter_.align(then_start, true);
                 });
  });
  connect(&presenter_, &TreatPresenter::overlayDrawn, pictures_, &CameraRow::showDrawn);
  connect(pictures_, &CameraRow::picked, this, [this](auto side, const QPointF& px, auto state) {
    if (tools_->isShown(Tool::check)) tip_.pick(side, px, *state);
  });
  const auto markOutdated = [this] {
    is_outdated_ = true;
    if (isVisible()) showCase();
  };
  connect(&model_, &CaseModel::opened, this, markOutdated);
  connect(&model_, &CaseModel::planChanged, this, markOutdated);
  connect(&model_, &CaseModel::signOffChanged, this, &TreatWorkspace::showSteps);
  connect(&TextScaleNotice::instance(), &TextScaleNotice::changed, this,
          [this] { keepWidthOf(guideWords(), *guide_); });
  showSteps();
  showStage(!presenter_.hasRecording());
}

QWidget* TreatWorkspace::makeSide() {
  side_ = new QStackedWidget(this);
  tools_ = new TreatSide(presenter_, motor_, check_, tip_, sounds_, *screens_, projector_, side_);
  side_->addWidget(tools_);
  side_->addWidget(new ScrollColumn(new CamerasPanel(presenter_, side_), TreatSide::kFigures_px, side_));
  return side_;
}

void TreatWorkspace::showTool(Tool tool) { tools_->showTool(tool); }

QWidget* TreatWorkspace::makeSteps() {
  auto* bar = new QFrame(this);
  bar->setObjectName("panel");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(10, 6, 10, 6);
  makeStepButtons(bar);
  makeChoices(bar);
  makeViewSwitches(bar);
  words_ = new ElidedLabel(bar);
  words_->setObjectName("muted");
  for (auto* button : {cameras_, align_, guide_, end_}) row->addWidget(button);
  row->addWidget(words_, 1);
  row->addWidget(show_slices_);
  row->addWidget(slices_in_scene_);
  row->addWidget(show_field_);
  row->addWidget(coil_);
  row->addWidget(target_);
  connectSteps();
  return bar;
}

void TreatWorkspace::makeStepButtons(QWidget* bar) {
  cameras_ = new QPushButton(bar);
  align_ = new QPushButton(bar);
  guide_ = new QPushButton(bar);
  cameras_->setToolTip(tr("cameras or a recording, their calibration and pictures (Ctrl+R)"));
  cameras_->setCheckable(true);
  cameras_->setShortcut(Qt::CTRL + Qt::Key_R);
  align_->setToolTip(tr("measure the face and fit it to the scan; no click is needed (Ctrl+L)"));
  align_->setShortcut(Qt::CTRL + Qt::Key_L);
  guide_->setToolTip(tr("start, stop or go on with guidance; the session stays open (Space)"));
  end_ = new QPushButton(tr("4 End\u2026"), bar);
  end_->setToolTip(tr("end the session: asks for pain and adverse events, then shows the report (Ctrl+E)"));
  end_->setShortcut(Qt::CTRL + Qt::Key_E);
  QSizePolicy policy = end_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);  // the buttons beside it stay where they are
  end_->setSizePolicy(policy);
  guide_->setShortcut(Qt::Key_Space);
  guide_->setObjectName("primary");
}

void TreatWorkspace::makeChoices(QWidget* bar) {
  target_ = new QComboBox(bar);
  target_->setAccessibleName(tr("target"));
  target_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  target_->setMinimumContentsLength(9);
  coil_ = new QComboBox(bar);
  coil_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  coil_->setMinimumContentsLength(10);
  coil_->setAccessibleName(tr("coil"));
  for (auto* choice : {coil_, target_}) markUsersWords(*choice);
  whenTextScales(this, [this] {
    for (auto* choice : {coil_, target_}) choice->setMinimumWidth(sized(90));  // where text is large
  });
}

void TreatWorkspace::connectSteps() {
  connectField();
  connect(cameras_, &QPushButton::clicked, this, &TreatWorkspace::showStage);
  connect(align_, &QPushButton::clicked, this, [this] { presenter_.align(false); });
  connect(guide_, &QPushButton::clicked, this, [this] {
    if (presenter_.isGuiding()) return presenter_.stopGuiding();
    if (presenter_.isEnding()) return presenter_.cancelEnd();
    showStage(false);
    presenter_.isPaused() ? presenter_.guide() : presenter_.start();
  });
  connect(end_, &QPushButton::clicked, &presenter_, &TreatPresenter::askEnd);
  connect(target_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { presenter_.chooseTarget(target_->currentText()); });
  connect(coil_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { presenter_.chooseCoil(coil_->currentText()); });
}

/// Step 1 shows the images large with the choice of cameras; the other steps show the scene and the figures.
void TreatWorkspace::showStage(bool shows_cameras) {
  side_->setCurrentIndex(shows_cameras ? 1 : 0);
  scene_->setVisible(!shows_cameras);
  slices_->setVisible(!shows_cameras && show_slices_->isChecked());
  field_view_->setVisible(!shows_cameras && field_.isOn());
  previewed_ = -1;
  cameras_->setChecked(shows_cameras);
  signature_.clear();
}

/// Shows the cameras' images before tracking starts.
void TreatWorkspace::showPreview() {
  const auto frame = presenter_.cameras().picture();
  if (!frame || frame->number == previewed_) return;
  previewed_ = frame->number;
  pictures_->showPlain(*frame);
}

void TreatWorkspace::showSteps() {
  const QString done(QChar(0x2713)), open(QChar(0x25cb)), wrong(QChar(0x2715));
  shows_moved_ = hasMoved();
  setWords(*cameras_, tr("1 Cameras %1").arg(shows_moved_ ? wrong : presenter_.hasRecording() ? done : open));
  setWords(*align_, tr("2 Align %1").arg(presenter_.isAligned() ? done : open));
  const bool has_begun = presenter_.isRunning() && !shows_running_;
  shows_running_ = presenter_.isRunning();
  // The alignment is shown at once: the MRI's skin over both pictures, beside the scene.
  const bool has_aligned = presenter_.isAligned() && !shows_aligned_;
  shows_aligned_ = presenter_.isAligned();
  if (has_begun || has_aligned) showStage(false);
  const QStringList guide_words = guideWords();
  setWords(*guide_, guide_words[presenter_.isGuiding() ? 0 : shows_running_ ? 1 : 2]);
  keepWidthOf(guide_words, *guide_);
  end_->setVisible(presenter_.hasSession());
  pictures_->setVisible(!presenter_.hasTracker());  // it has none
  align_->setEnabled(presenter_.canAlign());
  // Stopping is always possible.
  guide_->setEnabled(shows_running_ || (presenter_.isAligned() && presenter_.mayTreat()));
  showCoils();
  const QString doing = presenter_.doingWords();
  words_->setParts(!doing.isEmpty()  ? doing.split(": ")
                   : model_.isOpen() ? QStringList{presenter_.recordingWords(), presenter_.alignmentWords()}
                                     : QStringList{tr("open a case first (Ctrl+O)")});
  target_->clear();
  if (model_.isOpen())
    for (const auto& t : model_.current().plan.targets) target_->addItem(QString::fromStdString(t.name));
  target_->setCurrentIndex(target_->findText(presenter_.targetName()));
  target_->setToolTip(tr("the target to guide to: %1").arg(target_->currentText()));
  if (!is_outdated_ && model_.isOpen()) {
    scene_->scene().setTargets(model_.current().plan.targets, presenter_.targetName().toStdString());
    scene_->scene().setView(scene::ViewPreset::target);
    signature_.clear();
  }
}

/// Marks an outdated calibration at the coil's name, in its tooltip and in step 1.
void TreatWorkspace::showCoils() {
  const QString reminder = presenter_.coilReminder();
  coil_->clear();
  coil_->addItems(presenter_.coils());
  coil_->setCurrentText(presenter_.coilName());
  const bool is_old = !reminder.isEmpty() && presenter_.hasRecording();
  coil_->setToolTip(tr("the coil that is held: %1").arg(coil_->currentText()) +
                    (is_old ? "\n" + reminder : QString()));
  if (is_old) coil_->setItemIcon(coil_->currentIndex(), style()->standardIcon(QStyle::SP_MessageBoxWarning));
}

void TreatWorkspace::showCase() {
  if (!is_outdated_ || !model_.isOpen()) return;
  is_outdated_ = false;
  scene_->show(model_.current());
  slices_->show(model_.current());
  showSlicesInScene();
  showSteps();
}

bool TreatWorkspace::hasMoved() const { return !presenter_.withheldWords().isEmpty(); }

void TreatWorkspace::refresh() {
  const auto state = shownState();
  tools_->refreshPulses();
  pause_->refresh();
  check_.follow(*state);
  tip_.follow(*state);
  field_.follow(*state);
  // The check of a kept rig can finish at any time.
  if (presenter_.isRunning() != shows_running_ || presenter_.canAlign() != align_->isEnabled() ||
      hasMoved() != shows_moved_)
    showSteps();
  const bool was_started = presenter_.isRunning() || state->frame >= 0;
  const ReadOut read_out = readOut(*state, was_started);
  screens_->follow(state, read_out);
  if (isVisible())
    draw(state, read_out, was_started);
  else if (!screens_->areShown())
    timer_.stop();
  emit shown(read_out);
}

void TreatWorkspace::draw(const std::shared_ptr<const session::NavigationState>& state,
                          const ReadOut& read_out, bool was_started) {
  const bool shows_cameras = side_->currentIndex() == 1;
  if (shows_cameras && !presenter_.isRunning()) {
    showPreview();
    if (previewed_ < 0) pictures_->follow(state);  // no image yet; an old one must not stay
    return;
  }
  showPictures(state, was_started);
  // Redraws as soon as anything shown has changed: a blanked state must replace the last one at once.
  const QString signature = QStringList{QString::number(state->frame),
                                        read_out.instruction,
                                        read_out.across,
                                        read_out.depth,
                                        read_out.tilt,
                                        read_out.twist,
                                        read_out.face.words,
                                        read_out.coil.words,
                                        read_out.second,
                                        presenter_.showsSkin() ? "skin" : ""}
                                .join('|');
  const bool must_draw = signature_.isEmpty() || read_out.instruction != words_in_scene_;
  if (signature != signature_) followState(state, read_out);
  is_scene_behind_ |= signature != signature_;
  signature_ = signature;
  // Where rendering is slow (no graphics card), poses in between are left out; new words never wait.
  if (!must_draw && !(is_scene_behind_ && scene_share_.isDue())) return;
  is_scene_behind_ = false;
  words_in_scene_ = read_out.instruction;
  scene_share_.draw([&] { drawScene(*state, read_out, was_started); });
}

/// Shows the state in everything but the scene. The camera pictures come first: another thread draws them
/// while this one renders the scene, so they show the state that the scene shows.
void TreatWorkspace::followState(const std::shared_ptr<const session::NavigationState>& state,
                                 const ReadOut& read_out) {
  presenter_.askOverlay(state);
  slices_->follow(*state, read_out.instruction,
                  state->chosen ? presenter_.errorBound95_mm(state->chosen->target) : std::nullopt);
  tools_->show(state->guidance, read_out);
  presenter_.isGuiding() ? sounds_.follow(state->guidance) : sounds_.forget();
}

void TreatWorkspace::showEvent(QShowEvent*) {
  signature_.clear();
  showCase();
  keepWidthOf(guideWords(), *guide_);  // the text size may have changed
  field_.readChoices();
  timer_.start();
}

/// Keeps updating the second screens while another page is shown.
void TreatWorkspace::hideEvent(QHideEvent*) {
  if (screens_->areShown()) return;
  timer_.stop();
  field_.rest();
}

}  // namespace facenav::ui
