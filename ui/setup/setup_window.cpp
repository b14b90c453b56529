#include "setup/setup_window.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>

#include "home/fitted_words.h"
#include "setup/marked_picture.h"
#include "setup/setup_tools.h"
#include "shell/appearance.h"
#include "shell/help_window.h"
#include "shell/image_view.h"
#include "shell/narrow_label.h"
#include "shell/scroll_column.h"
#include "shell/shown_words.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

using Step = steps::SetupStep;

constexpr int kSetupRefresh_ms = 60, kToolsWidth_px = 270;

/// Heading of the manual's page set-up.md for the step.
QString headingOf(Step step) {
  switch (step) {
    case Step::place:
      break;
    case Step::calibrate:
      return "calibrate-facenav-calibrate";
    case Step::check:
      return "check";
    case Step::coil:
      return "the-coil-facenav-marker-calibrate-coil-coil";
  }
  return "in-the-window";
}

}  // namespace

SetupWindow::SetupWindow(const Services& services, QWidget* parent)
    : QWidget(parent, Qt::Window), services_(services), presenter_(services_, tasks_) {
  setWindowTitle(tr("FaceNav: set up the cameras"));
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 12, 16, 12);
  column->setSpacing(8);
  makeSteps(*column);
  makeMiddle(*column);
  makeBottom(*column);
  const auto complain = [this](const QString& words) {
    trouble_ = words;
    refresh();
  };
  connect(&presenter_, &SetupPresenter::refused, this, complain);
  connect(&tasks_, &TaskRunner::failed, this, complain);
  connect(&tasks_, &TaskRunner::started, this, [this] { trouble_.clear(); });
  connect(&presenter_, &SetupPresenter::kept, this, [this](const QString& name) {
    trouble_.clear();
    emit kept(name);
  });
  connect(&presenter_, &SetupPresenter::changed, this, &SetupWindow::refresh);
  connect(&timer_, &QTimer::timeout, this, &SetupWindow::refresh);
  timer_.start(kSetupRefresh_ms);
  presenter_.chooseCoil({});
  presenter_.lookForCameras();
  refresh();
}

SetupWindow::~SetupWindow() = default;

void SetupWindow::makeSteps(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  for (int i = 0; i < 4; ++i) {
    steps_[i] = new QPushButton(this);
    steps_[i]->setCheckable(true);
    steps_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    row->addWidget(steps_[i]);
    connect(steps_[i], &QPushButton::clicked, this, [this, i] {
      trouble_.clear();
      presenter_.go(Step(i));
      refresh();
    });
  }
  column.addLayout(row);
}

void SetupWindow::makeMiddle(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  auto* pictures = new QVBoxLayout;
  auto* pair = new QHBoxLayout;
  left_ = new ImageView(tr("left camera"), this);
  right_ = new ImageView(tr("right camera"), this);
  pair->addWidget(left_);
  pair->addWidget(right_);
  pictures->addLayout(pair, 6);
  sentence_ = new FittedWords(26, this);
  sentence_->setObjectName("setup_sentence");
  pictures->addWidget(sentence_, 2);
  lines_ = new QLabel(this);
  lines_->setObjectName("plain");
  makeNarrow(*lines_);
  auto* below = new ScrollColumn(lines_, 0, this);
  pictures->addWidget(below, 2);
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(8);
  pictures->addWidget(progress_);
  row->addLayout(pictures, 1);
  tools_ = new SetupTools(presenter_, this);
  auto* side = new ScrollColumn(tools_, kToolsWidth_px, this);
  row->addWidget(side);
  column.addLayout(row, 1);
}

void SetupWindow::makeBottom(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  back_ = new QPushButton(tr("Back"), this);
  next_ = new QPushButton(tr("Go on"), this);
  next_->setObjectName("primary");
  next_->setToolTip(tr("Return"));
  row->addWidget(back_);
  row->addStretch(1);
  row->addWidget(next_);
  column.addLayout(row);
  connect(back_, &QPushButton::clicked, this, &SetupWindow::goBack);
  connect(next_, &QPushButton::clicked, this, &SetupWindow::goOn);
  HelpWindow::addKey(*this, "set-up.md", [this] { return headingOf(presenter_.step()); });
  for (const int key : {Qt::Key_Return, Qt::Key_Enter})
    connect(new QShortcut(key, this), &QShortcut::activated, this, [this] {
      if (next_->isEnabled()) goOn();
    });
}

void SetupWindow::openKept(const QString& rig) {
  to_open_ = rig;
  refresh();
}

void SetupWindow::goOn() {
  trouble_.clear();
  if (presenter_.step() == Step::coil) return void(close());
  presenter_.go(Step(int(presenter_.step()) + 1));
}

void SetupWindow::goBack() {
  trouble_.clear();
  if (presenter_.step() != Step::place) presenter_.go(Step(int(presenter_.step()) - 1));
}

void SetupWindow::showSteps() {
  const QString names[4] = {tr("1  Place"), tr("2  Calibrate"), tr("3  Check"), tr("4  Coil")};
  for (int i = 0; i < 4; ++i) {
    const bool has_passed = i < int(presenter_.step());
    const bool is_active = i == int(presenter_.step());
    steps_[i]->setText(has_passed  ? names[i] + QString::fromUtf8("  \u2713")
                       : is_active ? QString::fromUtf8("\u25b6  ") + names[i]
                                   : names[i]);
    steps_[i]->setChecked(i == int(presenter_.step()));
    steps_[i]->setEnabled(presenter_.canGo(Step(i)));
  }
}

void SetupWindow::showLines(const steps::SetupView& view) {
  QStringList words;
  for (const auto& line : view.lines)
    words << (line.is_good ? QString::fromUtf8("\u2713  ") : QString::fromUtf8("\u2717  ")) +
                 shownWords(line.words);
  lines_->setText(words.join("\n").replace("+-", QString::fromUtf8("\u00b1")));
}

void SetupWindow::refresh() {
  if (!to_open_.isEmpty() && !tasks_.isRunning())
    return presenter_.openKept(std::exchange(to_open_, {}));  // refresh() follows
  presenter_.noteCheckOfKept();
  presenter_.keepRowTimes();
  showSteps();
  const auto view = presenter_.view();
  const bool is_of_step = view->step == presenter_.step();
  if (shown_ != view) {
    left_->set(markedPicture(*view, true));
    right_->set(markedPicture(*view, false));
    showLines(*view);
    progress_->setValue(int(100 * view->progress));
    shown_ = view;
  }
  tools_->refresh();
  const bool is_done = is_of_step && view->is_done;
  const bool is_bad = !trouble_.isEmpty() || !view->failure.empty() || view->needs_repair;
  sentence_->set(!trouble_.isEmpty()  ? trouble_
                 : tasks_.isRunning() ? tr("please wait: the cameras are opened")
                                      : presenter_.sentence(),
                 themeColour(is_bad    ? Colour::stop_words
                             : is_done ? Colour::good
                                       : Colour::text));
  back_->setEnabled(presenter_.step() != Step::place);
  const bool is_last = presenter_.step() == Step::coil;
  next_->setText(is_last ? tr("Close") : tr("Go on"));
  // A face may be missing while the cameras are placed: the nurse may sit there alone, or nobody does.
  next_->setEnabled(is_last || (presenter_.step() == Step::place && presenter_.isOpen()) ||
                    (is_done && presenter_.canGo(Step(int(presenter_.step()) + 1)) &&
                     (presenter_.step() != Step::check || presenter_.isKept())));
}

void SetupWindow::closeEvent(QCloseEvent* event) {
  timer_.stop();
  presenter_.close();
  event->accept();
}

}  // namespace facenav::ui
