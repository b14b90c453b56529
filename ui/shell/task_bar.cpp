#include "shell/task_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <QVariant>
#include <algorithm>

#include "shell/appearance.h"
#include "shell/elided_label.h"
#include "shell/task_runner.h"

namespace facenav::ui {
namespace {

constexpr int kReadable_ms = 4000;  // time to show a message during a task

}  // namespace

TaskBar::TaskBar(TaskRunner& tasks, QWidget* parent)
    : QFrame(parent),
      tasks_(tasks),
      words_(new ElidedLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName("taskbar");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 4, 14, 4);
  row->addWidget(words_, 1);
  row->addWidget(bar_);
  row->addWidget(cancel_);
  whenTextScales(this, [this] { bar_->setFixedWidth(sized(260)); });
  bar_->setRange(0, 1000);
  cancel_->setToolTip(tr("stop this step; nothing half-done is kept (Esc)"));
  cancel_->setShortcut(Qt::Key_Escape);
  cancel_->ensurePolished();  // the bar is as high without the button: the page above stays where it is
  whenTextScales(this, [this] {
    cancel_->ensurePolished();
    words_->setMinimumHeight(cancel_->sizeHint().height());
  });
  setBusy(false);
  connect(cancel_, &QPushButton::clicked, &tasks, &TaskRunner::cancel);
  connect(&tasks, &TaskRunner::started, this, [this](const QString& title) {
    title_ = title;
    elapsed_.start();
    said_.invalidate();
    bar_->setValue(0);
    showProgress({}, 0.0);
    setBusy(true);
  });
  connect(&tasks, &TaskRunner::progressed, this,
          [this](const QString& step, double f) { showProgress(step, f); });
  connect(&tasks, &TaskRunner::succeeded, this, [this] { showMessage(tr("%1: done").arg(title_), false); });
  connect(&tasks, &TaskRunner::cancelled, this,
          [this] { showMessage(tr("%1: cancelled").arg(title_), false); });
  connect(&tasks, &TaskRunner::failed, this, [this](const QString& words) { showMessage(words, true); });
}

void TaskBar::setBusy(bool is_busy) {
  bar_->setVisible(is_busy);
  cancel_->setVisible(is_busy);
}

/// Shows a task's progress. A step that is tried in another way starts anew; the bar does not fall.
void TaskBar::showProgress(const QString& step, double fraction) {
  bar_->setValue(std::max(bar_->value(), int(1000 * std::clamp(fraction, 0.0, 1.0))));
  if (said_.isValid() && said_.elapsed() < kReadable_ms) return;
  words_->setProperty("level", "none");
  words_->set(step.isEmpty() ? title_ + QChar(0x2026)
                             : tr("%1: %2  (%3 s)").arg(title_, step).arg(elapsed_.elapsed() / 1000));
}

void TaskBar::showMessage(const QString& words, bool is_failure) {
  say(is_failure ? tr("Could not be done: %1").arg(words) : words, is_failure);
}

void TaskBar::showNotice(const QString& words) { say(words, true); }

void TaskBar::say(const QString& words, bool is_caution) {
  setBusy(tasks_.isRunning());  // the task can still be cancelled
  is_caution ? said_.start() : said_.invalidate();
  words_->setProperty("level", is_caution ? "caution" : "none");
  words_->style()->unpolish(words_);
  words_->style()->polish(words_);
  words_->set(words);
}

}  // namespace facenav::ui
