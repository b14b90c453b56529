#include "review/review_workspace.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "review/compare_page.h"
#include "review/pulses_page.h"
#include "review/replay_page.h"
#include "review/report_page.h"
#include "review/sessions_panel.h"
#include "shell/typed_number.h"
#include "shell/words_of_button.h"

namespace facenav::ui {

ReviewWorkspace::ReviewWorkspace(ReviewPresenter& presenter, ReplayPresenter& replay, CaseModel& model,
                                 QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      model_(model),
      split_(new QSplitter(Qt::Horizontal, this)),
      pages_(new QStackedWidget(this)) {
  split_->setChildrenCollapsible(false);
  auto* left = new QWidget(split_);
  auto* of_case = new QVBoxLayout(left);
  of_case->setContentsMargins(0, 0, 0, 0);
  of_case->addWidget(makeFiles());
  sessions_ = new SessionsPanel(presenter_, left);
  of_case->addWidget(sessions_, 1);
  split_->addWidget(left);
  connect(sessions_, &SessionsPanel::replayWanted, this, [this] { setPage(ReviewPage::replay); });
  connect(split_, &QSplitter::splitterMoved, this, [this] { was_moved_ = true; });
  auto* right = new QWidget(split_);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(makeHead());
  pages_->addWidget(new PulsesPage(presenter_, model_, pages_));
  pages_->addWidget(new ReplayPage(replay, model_, pages_));
  pages_->addWidget(new ComparePage(presenter_, pages_));
  report_page_ = new ReportPage(presenter_, model_, pages_);
  pages_->addWidget(report_page_);
  connect(with_name_, &QCheckBox::toggled, report_page_, &ReportPage::setWithName);
  column->addWidget(pages_, 1);
  split_->addWidget(right);
  split_->setStretchFactor(0, 2);
  split_->setStretchFactor(1, 3);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 10, 10, 10);
  row->addWidget(split_);
  connect(&presenter_, &ReviewPresenter::sessionChanged, this, &ReviewWorkspace::showState);
  connect(&presenter_, &ReviewPresenter::sessionsChanged, this, &ReviewWorkspace::fitSessions,
          Qt::QueuedConnection);  // after the table has them
  connect(&model_, &CaseModel::opened, this, [this] {
    if (isVisible()) presenter_.refresh();
  });
  connect(&model_, &CaseModel::labelChanged, this, &ReviewWorkspace::showState);
  setPage(ReviewPage::pulses);
  showState();
}

QWidget* ReviewWorkspace::makeHead() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  tabs_ = new QButtonGroup(this);
  const QString names[4] = {tr("Pulses"), tr("Replay"), tr("Compare"), tr("Report")};
  const QString tips[4] = {tr("pulses on cortex and scalp, charts (Alt+1)"),
                           tr("the session frame by frame (Alt+2)"), tr("against another session (Alt+3)"),
                           tr("the report, to read (Alt+4)")};
  for (int i = 0; i < 4; ++i) {
    auto* button = new QPushButton(names[i], bar);
    button->setObjectName("tool");
    button->setCheckable(true);
    button->setToolTip(tips[i]);
    button->setShortcut(QKeySequence(Qt::ALT + Qt::Key_1 + i));
    button->ensurePolished();
    leaveRoomForBold(*button);
    tabs_->addButton(button, i);
    row->addWidget(button);
  }
  row->addStretch(1);
  with_name_ = new QCheckBox(tr("with label"), bar);
  with_name_->setToolTip(tr("adds the case's label, which may be the patient's name, to the report"));
  report_ = new QPushButton(tr("Write PDF"), bar);
  report_->setObjectName("primary");
  report_->setToolTip(tr("writes report.pdf, report.html and pulses.csv into the session's folder"));
  row->addWidget(with_name_);
  row->addWidget(report_);
  connect(tabs_, &QButtonGroup::idClicked, this, [this](int id) { setPage(ReviewPage(id)); });
  connect(report_, &QPushButton::clicked, this, [this] {
    setPage(ReviewPage::report);
    presenter_.makeReport(with_name_->isChecked());
  });
  return bar;
}

/// Files that add something to the sessions.
QWidget* ReviewWorkspace::makeFiles() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  from_home_ = new QPushButton(tr("From home\u2026"), bar);
  from_home_->setToolTip(tr("add the file that a session at home sent back"));
  meps_ = new QPushButton(tr("MEPs\u2026"), bar);
  meps_->setToolTip(
      tr("import from a CSV file with utc or t_s, and mep_uv, or from an XDF recording with markers and EMG; "
         "each goes to the pulse at its time"));
  row->addWidget(from_home_);
  row->addWidget(meps_);
  row->addStretch(1);
  connect(meps_, &QPushButton::clicked, this, &ReviewWorkspace::chooseMeps);
  connect(from_home_, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("The file that came back from home"), {}, tr("ZIP (*.zip)"));
    if (!file.isEmpty()) presenter_.addReturned(file);
  });
  return bar;
}

/// Gives the sessions the width of their columns, as far as the page beside them can do without it.
void ReviewWorkspace::fitSessions() {
  if (was_moved_ || !isVisible()) return;
  constexpr double kShare = 0.4;  // of the width, at least
  const int room_px = split_->width() - split_->handleWidth();
  const int most_px = room_px - split_->widget(1)->minimumSizeHint().width();
  const int left_px = std::min(std::max(sessions_->wantedWidth(), int(kShare * room_px)), most_px);
  split_->setSizes({left_px, room_px - left_px});
}

void ReviewWorkspace::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitSessions();
}

void ReviewWorkspace::setPage(ReviewPage page) {
  tabs_->button(int(page))->setChecked(true);
  pages_->setCurrentIndex(int(page));
}

ReviewPage ReviewWorkspace::page() const { return ReviewPage(pages_->currentIndex()); }

/// Asks for what only the user may know: streams of a recording, the offset of the clocks. An empty field
/// lets it be found.
void ReviewWorkspace::chooseMeps() {
  const QString file = QFileDialog::getOpenFileName(this, tr("MEPs by time"), {},
                                                    tr("CSV, or XDF of LabRecorder (*.csv *.xdf)"));
  if (file.isEmpty()) return;
  bool is_given = true;
  QString xdf;
  if (file.endsWith(".xdf", Qt::CaseInsensitive))
    xdf = QInputDialog::getText(
        this, tr("EMG and markers"),
        tr("STREAM:CHANNEL of the EMG; STREAM:MARKER of the pulses; uV or mV. Empty: find them"),
        QLineEdit::Normal, {}, &is_given);
  if (!is_given) return;
  const QString words = QInputDialog::getText(
      this, tr("Offset of the clocks"), tr("Seconds from the file's clock to the session's; empty: find it"),
      QLineEdit::Normal, {}, &is_given);
  if (!is_given) return;
  presenter_.importMeps(file, typedNumber(words), xdf);
}

void ReviewWorkspace::showState() {
  const bool has_session = presenter_.session() != nullptr;
  meps_->setEnabled(has_session);
  report_->setEnabled(has_session);
  from_home_->setEnabled(model_.isOpen());
  const bool has_label = model_.isOpen() && !model_.current().label.isEmpty();
  with_name_->setVisible(has_label);
  if (!has_label) with_name_->setChecked(false);
}

void ReviewWorkspace::showEvent(QShowEvent*) {
  presenter_.refresh();
  fitSessions();
}

}  // namespace facenav::ui
