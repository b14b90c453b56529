#include "review/replay_page.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>

#include "review/time_strip.h"
#include "shell/appearance.h"
#include "shell/image_view.h"
#include "shell/narrow_label.h"
#include "shell/scene_view.h"
#include "shell/words_of_button.h"

namespace facenav::ui {
namespace {

constexpr int kLeap = 50;  // frames per step with Shift

QImage grey(const cv::Mat& image) { return toQImage(image.data, image.cols, image.rows, int(image.step)); }

}  // namespace

ReplayPage::ReplayPage(ReplayPresenter& presenter, CaseModel& model, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      model_(model),
      scene_(new SceneView(this)),
      left_(new ImageView(tr("left camera"), this)),
      right_(new ImageView(tr("right camera"), this)),
      figures_(new QLabel(this)) {
  figures_->setObjectName("figures_text");
  makeNarrow(*figures_);
  whenTextScales(this, [this] { figures_->setMinimumHeight(sized(72)); });
  figures_->setToolTip(tr("as guidance.csv holds them for this frame"));
  auto* top = new QHBoxLayout;
  top->addWidget(scene_, 3);
  auto* side = new QVBoxLayout;
  for (auto* view : {left_, right_}) {
    whenTextScales(this, [view = view] { view->setMinimumSize(sized(120), sized(70)); });
    side->addWidget(view, 1);
  }
  side->addWidget(figures_);
  top->addLayout(side, 2);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(top, 1);
  column->addWidget(new TimeStrip(presenter_, this));
  column->addWidget(makeControls());
  addKeys();
  connect(&model_, &CaseModel::opened, this, [this] {
    is_outdated_ = true;
    if (isVisible()) showCase();
  });
  connect(&presenter_, &ReplayPresenter::opened, this, &ReplayPage::showTrack);
  connect(&presenter_, &ReplayPresenter::moved, this, &ReplayPage::showMoment);
  connect(&presenter_, &ReplayPresenter::pictureChanged, this, &ReplayPage::showPicture);
  showTrack();
}

QWidget* ReplayPage::makeControls() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  const auto button = [&](const QString& text, const QString& tip, auto action) {
    auto* made = new QPushButton(text, bar);
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, action);
    row->addWidget(made);
    return made;
  };
  back_ = button(tr("\u25c0|"), tr("one frame back (Left; with Shift: %1)").arg(kLeap),
                 [this] { presenter_.step(-1); });
  play_ = button(tr("Play"), tr("play and pause, as fast as it was (Space)"),
                 [this] { presenter_.isPlaying() ? presenter_.pause() : presenter_.play(); });
  whenTextScales(this, [this] { play_->setMinimumWidth(sized(84)); });
  forward_ = button(tr("|\u25b6"), tr("one frame on (Right; with Shift: %1)").arg(kLeap),
                    [this] { presenter_.step(1); });
  time_ = new QLabel(bar);
  makeNarrow(*time_);
  row->addWidget(time_, 1);
  button(tr("Track\u2026"), tr("another folder with poses.csv, as `facenav track` writes it"), [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder with poses.csv"));
    if (!folder.isEmpty()) presenter_.openFolder(folder);
  });
  overlay_ = button(tr("Overlay"),
                    tr("the scalp, the coil and the target drawn into the pictures, where "
                       "the poses of this frame put them (O)"),
                    [this] { showPicture(); });
  overlay_->setObjectName("tool");
  overlay_->setCheckable(true);
  overlay_->setChecked(true);
  overlay_->setShortcut(Qt::Key_O);
  pictures_ =
      button(tr("Pictures\u2026"), tr("the folder of the session's recording, if it is elsewhere"), [this] {
        const QString folder = QFileDialog::getExistingDirectory(this, tr("Recording of this session"));
        if (!folder.isEmpty()) presenter_.choosePictures(folder);
      });
  return bar;
}

void ReplayPage::addKeys() {
  const auto key = [this](const QKeySequence& keys, const QString& words, auto action) {
    auto* shortcut = new QShortcut(keys, this);
    shortcut->setWhatsThis(words);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  key(Qt::Key_Left, tr("one frame back"), [this] { presenter_.step(-1); });
  key(Qt::Key_Right, tr("one frame on"), [this] { presenter_.step(1); });
  key(Qt::SHIFT + Qt::Key_Left, tr("%1 frames back").arg(kLeap), [this] { presenter_.step(-kLeap); });
  key(Qt::SHIFT + Qt::Key_Right, tr("%1 frames on").arg(kLeap), [this] { presenter_.step(kLeap); });
  key(Qt::Key_Space, tr("play and pause"),
      [this] { presenter_.isPlaying() ? presenter_.pause() : presenter_.play(); });
}

void ReplayPage::showCase() {
  if (!is_outdated_ || !model_.isOpen()) return;
  is_outdated_ = false;
  scene_->show(model_.current());
  showTarget(std::nullopt);
}

void ReplayPage::showTrack() {
  const bool is_open = presenter_.isOpen();
  for (auto* button : {back_, play_, forward_, pictures_}) button->setEnabled(is_open);
  if (!is_open) {
    figures_->clear();
    time_->setText(presenter_.problem());
    scene_->scene().setLive(false);
    scene_->scene().setBanner("");
    scene_->refresh();
  }
  showTarget(std::nullopt);
  if (isVisible() && !is_open) presenter_.open();
  showPicture();
  showMoment();
}

/// Shows the target as it was then: a target may be moved during a session and keep its name.
void ReplayPage::showTarget(const std::optional<guidance::Target>& target) {
  const bool is_same = target.has_value() == target_.has_value() &&
                       (!target || (target->name == target_->name && target->mri_T_target.isometry().isApprox(
                                                                         target_->mri_T_target.isometry())));
  if (is_same) return;
  const bool is_first = !target_.has_value();
  target_ = target;
  auto& scene = scene_->scene();
  scene.setTargets(target ? std::vector<guidance::Target>{*target} : std::vector<guidance::Target>{},
                   target ? target->name : std::string());
  if (is_first) scene.setView(scene::ViewPreset::target);
}

void ReplayPage::showMoment() {
  if (!presenter_.isOpen() || !isVisible() || is_outdated_) return;
  setWords(*play_, presenter_.isPlaying() ? tr("Pause") : tr("Play"));
  time_->setText(presenter_.timeWords());
  const QString loss = presenter_.lossWords();
  figures_->setText(loss.isEmpty() ? presenter_.figures() : tr("LOST: %1").arg(loss));
  auto& scene = scene_->scene();
  showTarget(presenter_.target());
  const auto& moment = presenter_.moment();
  const auto& track = presenter_.track();
  const auto head = track.is_in_mri ? moment.camera_T_mri() : std::nullopt;
  const auto coil = track.is_coil ? moment.camera_T_coil() : std::nullopt;
  const Lost lost{LostReason::stale};  // the words over the scene give the reason from the file
  scene.setHeadPose(head ? Tracked<RigidTransform<Camera, Mri>>(*head, 1.0) : lost);
  scene.setCoilPose(coil ? Tracked<RigidTransform<Camera, Coil>>(*coil, 1.0) : lost);
  scene.setOnTarget(track.word(moment.state) == "on_target");
  scene.setBanner(loss.isEmpty() ? std::string() : loss.toUpper().toStdString());
  scene_->refreshMoving();
  if (presenter_.picture() && presenter_.picture()->number != moment.frame) showPicture();
}

/// Shows the picture only if it is of the same moment as the figures.
void ReplayPage::showPicture() {
  const auto frame = presenter_.isOpen() ? presenter_.picture() : nullptr;
  const bool is_of_moment = frame && (frame->number == presenter_.moment().frame || presenter_.isPlaying());
  const QString why = frame ? tr("reading the picture") : presenter_.picturesWords();
  const auto drawn = is_of_moment && overlay_->isChecked() ? presenter_.overlay() : nullptr;
  left_->set(drawn ? toQImage(drawn->left) : is_of_moment ? grey(frame->left) : QImage(), why);
  right_->set(drawn ? toQImage(drawn->right) : is_of_moment ? grey(frame->right) : QImage(), why);
}

void ReplayPage::showEvent(QShowEvent*) {
  showCase();
  presenter_.open();
  showTrack();
}

void ReplayPage::hideEvent(QHideEvent*) { presenter_.pause(); }

}  // namespace facenav::ui
