#include "home/home_window.h"

#include <QCloseEvent>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QStandardPaths>
#include <QStorageInfo>
#include <QVBoxLayout>

#include "home/fitted_words.h"
#include "home/sign_view.h"
#include "shell/appearance.h"
#include "shell/help_window.h"
#include "shell/image_view.h"
#include "shell/shown_words.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

using Stage = HomePresenter::Stage;

constexpr int kRefresh_ms = 50;
/// True for a stick or card that the desktop has mounted and that can be written to.
bool isStick(const QStorageInfo& volume) {
  const QString root = volume.rootPath();
  return volume.isValid() && volume.isReady() && !volume.isReadOnly() &&
         (root.startsWith("/media/") || root.startsWith("/run/media/"));
}

/// The desktop (else the documents), then every USB stick.
QStringList placesToSave() {
  QStringList places;
  for (const auto location : {QStandardPaths::DesktopLocation, QStandardPaths::DocumentsLocation}) {
    const QString folder = QStandardPaths::writableLocation(location);
    if (places.isEmpty() && QFileInfo(folder).isWritable()) places << folder;
  }
  for (const auto& volume : QStorageInfo::mountedVolumes())
    if (isStick(volume)) places << volume.rootPath();
  return places;
}

/// An advice with the full stop of the window's language.
QString adviceInWords(const std::string& advice) {
  const QString words = shownWords(advice);
  return words.endsWith('.') ? HomeWindow::tr("%1.").arg(words.chopped(1)) : words;
}

}  // namespace

HomeWindow::HomeWindow(const Services& services, QWidget* parent)
    : QWidget(parent), services_(services), presenter_(services_, tasks_) {
  setWindowTitle(tr("FaceNav at home"));
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(24, 16, 24, 20);
  column->setSpacing(12);
  auto* steps = new QHBoxLayout;
  for (auto*& step : steps_) {
    step = new FittedWords(22, this);
    steps->addWidget(step);
  }
  column->addLayout(steps, 2);
  auto* middle = new QHBoxLayout;
  sign_ = new SignView(this);
  picture_ = new ImageView(QString(), this);
  middle->addWidget(sign_, 1);
  middle->addWidget(picture_, 1);
  column->addLayout(middle, 8);
  words_ = new FittedWords(34, this);
  words_->setObjectName("home_words");
  column->addWidget(words_, 4);
  counts_ = new FittedWords(16, this);
  column->addWidget(counts_, 1);
  button_ = new QPushButton(this);
  button_->setObjectName("primary");
  button_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  button_->setMinimumHeight(64);
  button_->setToolTip(tr("Return"));
  auto* inside = new QVBoxLayout(button_);
  inside->setContentsMargins(12, 4, 12, 4);
  button_words_ = new FittedWords(28, button_);
  button_words_->setAttribute(Qt::WA_TransparentForMouseEvents);
  inside->addWidget(button_words_);
  column->addWidget(button_, 3);
  connect(button_, &QPushButton::clicked, this, &HomeWindow::press);
  for (const int key : {Qt::Key_Return, Qt::Key_Enter})
    connect(new QShortcut(key, this), &QShortcut::activated, this, &HomeWindow::press);
  auto* pulse = new QShortcut(Qt::Key_P, this);
  pulse->setAutoRepeat(false);
  connect(pulse, &QShortcut::activated, this, [this] { presenter_.countPulse(times_.pressed()); });
  HelpWindow::addKey(*this, "home.md", "at-home");
  connect(&presenter_, &HomePresenter::changed, this, &HomeWindow::refresh);
  connect(&presenter_, &HomePresenter::saveWanted, this, &HomeWindow::saveFile);
  connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, &presenter_, &HomePresenter::goOn);
  connect(&tasks_, &TaskRunner::succeeded, this, &HomeWindow::refresh);
  connect(&timer_, &QTimer::timeout, this, &HomeWindow::refresh);
  timer_.start(kRefresh_ms);
  refresh();
}

HomeWindow::~HomeWindow() = default;

void HomeWindow::press() {
  if (presenter_.stage() == Stage::ended && !presenter_.savedAs().isEmpty()) return void(close());
  presenter_.act();
}

/// Saves on the desktop and on each USB stick, without a dialog. Asks for a place only if neither works.
void HomeWindow::saveFile() {
  places_ = presenter_.saveIn(placesToSave());
  if (!places_.isEmpty()) return refresh();
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save the file to send"),
                                   QDir::homePath() + "/" + presenter_.sendBackName(), tr("ZIP (*.zip)"));
  if (presenter_.save(file)) places_ = QStringList{QFileInfo(file).absolutePath()};
  refresh();
}

/// `active`: index of the current step, 0 to 2; 3 if all are done.
void HomeWindow::showSteps(int active, bool is_done) {
  const QString names[3] = {tr("1  Sit and look"), tr("2  Hold the coil"), tr("3  Follow the arrow")};
  for (int i = 0; i < 3; ++i) {
    const bool has_passed = (i < active && active < 3) || is_done;
    steps_[i]->set(has_passed    ? names[i] + QString("  \u2713")
                   : i == active ? QString("\u25b6 ") + names[i]
                                 : names[i],
                   themeColour(has_passed    ? Colour::good
                               : i == active ? Colour::now
                                             : Colour::muted));
  }
}

/// Shows the camera's picture mirrored.
void HomeWindow::showPicture() {
  auto frame = presenter_.state()->images;
  if (!frame) frame = presenter_.cameras().picture();
  if (!frame) frame = presenter_.stillPicture();
  if (!frame) {
    if (shown_ != -1) picture_->set({});
    shown_ = -1;
    return;
  }
  if (frame->number == shown_) return;
  shown_ = frame->number;
  picture_->set(toQImage(frame->left.data, frame->left.cols, frame->left.rows, int(frame->left.step))
                    .mirrored(true, false));
}

/// "facenav_20261123T140509Z.zip: on the desktop, on the USB stick KINGSTON".
QString HomeWindow::savedWords() const {
  QStringList where;
  const QString desktop = QStandardPaths::writableLocation(QStandardPaths::DesktopLocation);
  for (const QString& place : places_)
    where << (place == desktop               ? tr("on the desktop")
              : isStick(QStorageInfo(place)) ? tr("on the USB stick %1").arg(QFileInfo(place).fileName())
                                             : tr("in %1").arg(place));
  if (where.isEmpty()) return presenter_.savedAs();
  return QFileInfo(presenter_.savedAs()).fileName() + ": " + where.join(", ");
}

void HomeWindow::refresh() {
  const Stage stage = presenter_.stage();
  const bool is_ended = stage == Stage::ended || stage == Stage::ending;
  if (stage == Stage::guiding) {
    const auto advice = presenter_.advice();
    const bool is_asked = presenter_.asksToFinish();
    showSteps(int(advice.step), false);
    sign_->set(is_asked ? steps::HomeSign::none : advice.sign, advice.arrow_rad, advice.is_refused);
    words_->set(is_asked ? presenter_.words() : adviceInWords(advice.words),
                themeColour(advice.is_refused && !is_asked ? Colour::stop_words : Colour::text));
  } else {
    const bool is_refused = !presenter_.refusal().isEmpty();
    // A tick is for pulses on target, not for having pressed the button.
    const bool is_done = is_ended && presenter_.pulseCounts().on_target > 0;
    showSteps(is_ended ? 3 : 0, is_done);
    sign_->set(is_done && !is_refused ? steps::HomeSign::hold : steps::HomeSign::none, 0, is_refused);
    words_->set(presenter_.words(), themeColour(is_refused ? Colour::stop_words : Colour::text));
  }
  showPicture();
  picture_->setVisible(!is_ended);
  const auto counts = presenter_.pulseCounts();
  const auto planned = presenter_.plannedPulses();
  QString said = presenter_.reminder();
  if (stage == Stage::guiding || is_ended) {
    said = planned ? tr("%1 of %2 pulses on target").arg(counts.on_target).arg(*planned)
                   : tr("%1 pulses on target").arg(counts.on_target);
    if (counts.outside + counts.lost > 0) said += tr(", %1 not on target").arg(counts.outside + counts.lost);
  }
  if (stage == Stage::ended && !presenter_.savedAs().isEmpty()) said += "\n" + savedWords();
  counts_->set(said, themeColour(Colour::muted));
  const QString action = presenter_.actionWords();
  button_->setVisible(!action.isEmpty());
  button_words_->set(action, themeColour(Colour::on_accent));
  button_->setAccessibleName(action);
}

void HomeWindow::closeEvent(QCloseEvent* event) {
  timer_.stop();
  event->accept();
}

}  // namespace facenav::ui
