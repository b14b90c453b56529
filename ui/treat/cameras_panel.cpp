#include "treat/cameras_panel.h"

#include <QComboBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "setup/latency_screen.h"
#include "shell/appearance.h"
#include "shell/scroll_column.h"
#include "shell/words_of_button.h"
#include "treat/camera_choice.h"
#include "treat/tracker_panel.h"

namespace facenav::ui {
namespace {

constexpr int kRefresh_ms = 300;
// The words above the button grow in the first two seconds and would push it out of view.
constexpr int kBrings = 2000 / kRefresh_ms;

QLabel* label(const QString& text, const char* name, QWidget* parent) {
  auto* made = new QLabel(text, parent);
  made->setObjectName(name);
  made->setWordWrap(true);
  return made;
}

/// Highlights the button to press next.
void setPrimary(QPushButton& button, bool is_primary) {
  const QString name = is_primary ? QStringLiteral("primary") : QString();
  if (button.objectName() == name) return;
  button.setObjectName(name);
  button.style()->unpolish(&button);
  button.style()->polish(&button);
}

constexpr int kVerdict_px = 71;  // two lines of the verdict's letters and its edge

/// Lets the layout choose the box's width, not its longest name.
void setNarrow(QComboBox& box) {
  box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box.setMinimumContentsLength(10);
}

}  // namespace

CamerasPanel::CamerasPanel(TreatPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter), cameras_(presenter.cameras()) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->addWidget(label(tr("Cameras"), "heading", this));
  state_ = label({}, "verdict", this);
  column->addWidget(state_);  // first: with large text the rest is below the fold
  whenTextScales(this, [this] { state_->setMinimumHeight(sized(kVerdict_px)); });  // the buttons stay
  addChoice(*column);
  addCapture(*column);
  coil_words_ = label({}, "plain", this);
  column->addWidget(coil_words_);
  column->addStretch(1);
  auto* recording = button(tr("Open a recording\u2026"), tr("a folder with stereo.yml, played as if live"),
                           Qt::CTRL + Qt::SHIFT + Qt::Key_R);
  column->addWidget(recording);
  connect(recording, &QPushButton::clicked, this, &CamerasPanel::chooseRecording);
  column->addWidget(new TrackerPanel(presenter, this));
  timer_.setInterval(kRefresh_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { isVisible() ? showState() : timer_.stop(); });
  connect(&cameras_, &CamerasPresenter::changed, this, [this] {
    fillDevices();
    fillRigs();
    showState();
  });
}

QPushButton* CamerasPanel::button(const QString& text, const QString& tip, const QKeySequence& key) {
  auto* made = new QPushButton(text, this);
  made->setToolTip(tr("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  made->setShortcut(key);
  return made;
}

void CamerasPanel::addChoice(QVBoxLayout& column) {
  auto* grid = new QGridLayout;
  left_ = new QComboBox(this);
  right_ = new QComboBox(this);
  left_->setAccessibleName(tr("left camera"));
  right_->setAccessibleName(tr("right camera"));
  for (auto* box : {left_, right_}) {
    setNarrow(*box);
    letAddressBeTyped(*box);
  }
  left_->setToolTip(tr("the camera on the left as seen from behind the pair, facing the patient"));
  right_->setToolTip(tr("the camera on the right as seen from behind the pair, facing the patient"));
  auto* again = button(tr("Look again"), tr("which cameras are plugged in"), Qt::Key_F5);
  auto* swap = button(tr("Swap"), tr("left for right"), Qt::CTRL + Qt::Key_W);
  auto* choose_rig =
      button(tr("Calibration\u2026"), tr("the stereo.yml of these two cameras"), Qt::CTRL + Qt::Key_K);
  open_ = button(tr("Open the cameras"), tr("live pictures"), Qt::CTRL + Qt::Key_Return);
  rig_ = label({}, "plain", this);
  grid->addWidget(new QLabel(tr("left"), this), 0, 0);
  grid->addWidget(left_, 0, 1);
  grid->addWidget(swap, 0, 2);
  grid->addWidget(new QLabel(tr("right"), this), 1, 0);
  grid->addWidget(right_, 1, 1);
  grid->addWidget(again, 1, 2);
  addNamedRig(*grid);
  grid->addWidget(choose_rig, 2, 2);
  grid->setColumnStretch(1, 1);
  column.addLayout(grid);
  column.addWidget(rig_);  // not in the grid, which would cut a wrapped text over several columns
  column.addWidget(open_);
  addSetUp(column);
  connect(again, &QPushButton::clicked, &cameras_, &CamerasPresenter::lookEverywhere);
  connect(swap, &QPushButton::clicked, &cameras_, &CamerasPresenter::swapSides);
  connect(choose_rig, &QPushButton::clicked, this, &CamerasPanel::chooseRig);
  connect(open_, &QPushButton::clicked, &cameras_, &CamerasPresenter::open);
  const auto choose = [this] {
    const QString left = chosenCamera(*left_), right = chosenCamera(*right_);
    if (left != cameras_.left() || right != cameras_.right()) cameras_.choose(left, right);
  };
  for (auto* box : {left_, right_}) {
    connect(box, QOverload<int>::of(&QComboBox::activated), this, choose);
    connect(box->lineEdit(), &QLineEdit::editingFinished, this, choose);
  }
}

void CamerasPanel::addNamedRig(QGridLayout& grid) {
  named_rig_ = new QComboBox(this);
  named_rig_->setAccessibleName(tr("rig"));
  setNarrow(*named_rig_);
  named_rig_->setToolTip(tr("cameras, settings and calibration kept under a name (facenav rig new)"));
  grid.addWidget(new QLabel(tr("rig"), this), 2, 0);
  grid.addWidget(named_rig_, 2, 1);
  connect(named_rig_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    const QString name = named_rig_->currentData().toString();
    if (!name.isEmpty()) cameras_.chooseRig(name);
  });
}

void CamerasPanel::addSetUp(QVBoxLayout& column) {
  set_up_ = button(tr("Set up the cameras\u2026"), tr("place, calibrate and check a pair in four steps"),
                   Qt::CTRL + Qt::SHIFT + Qt::Key_U);
  latency_ = button(tr("Measure the delay\u2026"),
                    tr("from the left camera to the screen: it films a flashing field"),
                    Qt::CTRL + Qt::SHIFT + Qt::Key_L);
  auto* seldom = new QHBoxLayout;
  seldom->addWidget(set_up_);
  seldom->addWidget(latency_);
  column.addLayout(seldom);
  connect(latency_, &QPushButton::clicked, this, [this] {
    auto* screen = new LatencyScreen([this] { return cameras_.picture(); }, window());
    screen->setAttribute(Qt::WA_DeleteOnClose);
    screen->resize(sized(900), sized(600));
    screen->show();
  });
  connect(set_up_, &QPushButton::clicked, &cameras_, &CamerasPresenter::askForSetUp);
}

void CamerasPanel::addCapture(QVBoxLayout& column) {
  column.addWidget(label(tr("Picture for the alignment"), "heading", this));
  capture_words_ = label({}, "plain", this);
  column.addWidget(capture_words_);
  marked_ =
      button(tr("Take the picture"), tr("the face with the coil's marker beside it; no projector is needed"),
             Qt::CTRL + Qt::Key_T);
  column.addWidget(marked_);
  dots_ = button(tr("1 With dots"), tr("the face with the projector on"), Qt::CTRL + Qt::Key_D);
  plain_ = button(tr("2 Without dots"), tr("the face as it was, the projector off"), Qt::CTRL + Qt::Key_P);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("or with a projector"), this));
  row->addWidget(dots_);
  row->addWidget(plain_);
  column.addLayout(row);
  connect(marked_, &QPushButton::clicked, &cameras_, &CamerasPresenter::takeMarked);
  connect(dots_, &QPushButton::clicked, &cameras_, &CamerasPresenter::takeDots);
  connect(plain_, &QPushButton::clicked, &cameras_, &CamerasPresenter::takePlain);
}

void CamerasPanel::fillDevices() {
  listCameras(*left_, cameras_.devices(), cameras_.left());
  listCameras(*right_, cameras_.devices(), cameras_.right());
}

void CamerasPanel::fillRigs() {
  named_rig_->clear();
  named_rig_->addItem(cameras_.rigNames().isEmpty() ? tr("none kept under a name") : tr("chosen one by one"),
                      QString());
  for (const QString& name : cameras_.rigNames()) named_rig_->addItem(name, name);
  named_rig_->setEnabled(named_rig_->count() > 1);
  named_rig_->setCurrentIndex(std::max(0, named_rig_->findData(cameras_.rigName())));
}

void CamerasPanel::showState() {
  const QString reminder = presenter_.coilReminder();
  coil_words_->setText(tr("Coil: %1").arg(presenter_.coilName()) +
                       (reminder.isEmpty() ? QString() : "\n" + reminder));
  rig_->setText(cameras_.rigWords());
  const QString fault = presenter_.rigFault();
  const char* level = !fault.isEmpty()         ? "caution"
                      : cameras_.isWell()      ? "good"
                      : cameras_.hasPictures() ? "caution"
                                               : "lost";
  if (state_->property("level").toString() != level) {
    state_->setProperty("level", level);
    state_->style()->unpolish(state_);
    state_->style()->polish(state_);
  }
  state_->setText(fault.isEmpty() ? cameras_.words() : fault);
  open_->setEnabled(cameras_.canOpen() && !presenter_.isRunning());
  set_up_->setEnabled(!presenter_.isRunning() && cameras_.mayClose());
  latency_->setEnabled(cameras_.isLive() && !presenter_.isRunning());
  setWords(*set_up_, !fault.isEmpty()               ? tr("Check and repair the cameras\u2026")
                     : cameras_.rigName().isEmpty() ? tr("Set up the cameras\u2026")
                                                    : tr("Check the cameras\u2026"));
  setWords(*open_, cameras_.isLive() ? tr("Open the cameras again") : tr("Open the cameras"));
  const bool is_withheld = !presenter_.withheldWords().isEmpty();
  const bool is_live = cameras_.isLive() && !presenter_.isRunning() && !is_withheld;
  setPrimary(*set_up_, is_withheld);
  setPrimary(*marked_, is_live);
  setPrimary(*open_, !is_withheld && !is_live);
  if (is_live && !marked_->isEnabled()) brings_ = kBrings;  // the cameras were opened just now
  marked_->setEnabled(is_live);
  dots_->setEnabled(is_live);
  plain_->setEnabled(is_live && cameras_.hasDots());
  capture_words_->setText(is_live       ? cameras_.captureWords()
                          : is_withheld ? tr("after the cameras are repaired")
                                        : tr("with live cameras: the face, and the coil's marker beside it"));
  if (brings_ > 0)
    --brings_, QTimer::singleShot(0, marked_, [this] { ScrollColumn::bringIntoView(*marked_); });
}

void CamerasPanel::chooseRig() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Calibration of the cameras"),
                                                    cameras_.rigFile(), tr("Calibration (*.yml *.yaml)"));
  if (!path.isEmpty()) cameras_.setRigFile(path);
}

void CamerasPanel::chooseRecording() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a recording"));
  if (!folder.isEmpty()) presenter_.openRecording(folder);
}

void CamerasPanel::showEvent(QShowEvent*) {
  cameras_.refreshDevices();
  showState();
  timer_.start();
}

}  // namespace facenav::ui
