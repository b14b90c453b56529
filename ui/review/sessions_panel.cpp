#include "review/sessions_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPersistentModelIndex>
#include <QPushButton>
#include <QShortcut>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "facenav/report/local_time.h"
#include "shell/appearance.h"
#include "shell/author.h"
#include "shell/narrow_label.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr int kToTheMinute = 16;  // "2026-11-20 13:45"

QString minutes(const std::optional<double>& seconds) {
  if (!seconds) return QString::fromUtf8("\u2013");
  const auto whole = qlonglong(std::lround(*seconds));
  return QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0'));
}

QString spread(const std::optional<report::Spread>& value) {
  if (!value) return QString::fromUtf8("\u2013");
  return QString("%1 / %2").arg(value->median, 0, 'f', 1).arg(value->p95, 0, 'f', 1);
}

void arrange(QTableView& view) {
  view.setSelectionBehavior(QAbstractItemView::SelectRows);
  view.setShowGrid(false);
  view.setAlternatingRowColors(true);
  view.setTabKeyNavigation(false);
  view.verticalHeader()->hide();
  whenTextScales(&view, [&view] { view.verticalHeader()->setDefaultSectionSize(sized(28)); });
  view.horizontalHeader()->setHighlightSections(false);
}

}  // namespace

SessionsPanel::SessionsPanel(ReviewPresenter& presenter, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      table_(new PulseTable(presenter, this)),
      sorted_(new QSortFilterProxyModel(this)),
      sessions_(new QTableWidget(this)),
      pulses_(new QTableView(this)),
      words_(new QLabel(this)) {
  makeSessions();
  makePulses();
  words_->setObjectName("muted");
  makeNarrow(*words_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(sessions_, 1);
  column->addWidget(words_);
  column->addWidget(pulses_, 3);
  column->addWidget(makeEdits());
  connect(&presenter_, &ReviewPresenter::sessionsChanged, this, &SessionsPanel::showSessions);
  connect(&presenter_, &ReviewPresenter::sessionChanged, this, &SessionsPanel::showState);
  connect(&presenter_, &ReviewPresenter::markedChanged, this, &SessionsPanel::showMarked);
  showSessions();
  showState();
}

void SessionsPanel::makeSessions() {
  arrange(*sessions_);
  const QStringList names{tr("session"), tr("pulses"), tr("on"),  tr("error"),
                          tr("lost"),    tr("off"),    tr("95 %")};  // short: seven fit at 1280
  sessions_->setColumnCount(names.size());
  sessions_->setHorizontalHeaderLabels(names);
  const QString tips[] = {tr("start of the session"),
                          tr("all pulses; in brackets: excluded"),
                          tr("pulses within the tolerance, of those that are not excluded"),
                          tr("distance of coil and target at the pulses, median / 95th percentile, mm"),
                          tr("time with face or coil lost, min:s"),
                          tr("time outside the tolerance, with losses, min:s"),
                          tr("error of the alignment at the target: 95 % of such alignments are within, mm")};
  for (int i = 0; i < names.size(); ++i) sessions_->horizontalHeaderItem(i)->setToolTip(tips[i]);
  whenTextScales(this, [this] { sessions_->horizontalHeader()->setMinimumSectionSize(sized(30)); });
  sessions_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  sessions_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  sessions_->setSelectionMode(QAbstractItemView::SingleSelection);
  sessions_->setAccessibleName(tr("sessions"));
  whenTextScales(this, [this] { sessions_->setMinimumSize(sized(240), sized(90)); });
  connect(sessions_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (!is_filling_ && row >= 0) presenter_.choose(sessions_->item(row, 0)->data(Qt::UserRole).toString());
  });
}

void SessionsPanel::makePulses() {
  arrange(*pulses_);
  sorted_->setSourceModel(table_);
  sorted_->setSortRole(PulseTable::kSortRole);
  pulses_->setModel(sorted_);
  pulses_->setSortingEnabled(true);
  pulses_->sortByColumn(PulseTable::kNumber, Qt::AscendingOrder);
  pulses_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  pulses_->setAccessibleName(tr("pulses"));
  whenTextScales(this, [this] { pulses_->setMinimumSize(sized(240), sized(110)); });
  pulses_->setToolTip(tr("click a heading to sort; double click an MEP to type it"));
  whenTextScales(this, [this] { fitPulseColumns(); });
  connect(table_, &PulseTable::modelReset, this, &SessionsPanel::fitPulseColumns);
  pulses_->horizontalHeader()->setStretchLastSection(true);
  connect(pulses_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& row) {
            if (row.isValid()) presenter_.mark(table_->numberAt(sorted_->mapToSource(row).row()));
          });
  connect(pulses_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SessionsPanel::showState);
  pulses_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(pulses_, &QTableView::customContextMenuRequested, this, &SessionsPanel::showMenu);
}

/// Gives each column what it needs: headings are whole, with room for the arrow of sorting. Columns without a
/// value are hidden; a long target is cut, and whole in its tip.
void SessionsPanel::fitPulseColumns() {
  constexpr int kArrow_px = 14, kLongestTarget_px = 110;
  auto* header = pulses_->horizontalHeader();
  header->ensurePolished();
  for (int i = 0; i < header->count(); ++i) {
    header->setSectionHidden(i, table_->isEmptyColumn(i));
    if (header->isSectionHidden(i)) continue;
    pulses_->resizeColumnToContents(i);
    const int cells_px = i == PulseTable::kTarget ? std::min(header->sectionSize(i), sized(kLongestTarget_px))
                                                  : header->sectionSize(i);
    header->resizeSection(i, std::max(cells_px, header->sectionSizeHint(i) + sized(kArrow_px)));
  }
}

int SessionsPanel::wantedWidth() const {
  return sessions_->horizontalHeader()->length() + 2 * sessions_->frameWidth();
}

/// Shows what can be done with the chosen pulses.
void SessionsPanel::showMenu(const QPoint& at) {
  const int counted = int(chosen(false).size()), excluded = int(chosen(true).size());
  if (counted + excluded == 0) return;
  auto* menu = new QMenu(this);
  menu->setObjectName("pulses_menu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (counted > 0)
    menu->addAction(counted == 1 ? tr("Exclude\u2026") : tr("Exclude %1 pulses\u2026").arg(counted), this,
                    &SessionsPanel::excludeChosen);
  if (excluded > 0)
    menu->addAction(excluded == 1 ? tr("Take in") : tr("Take in %1 pulses").arg(excluded), include_,
                    &QPushButton::click);
  if (counted + excluded == 1) {
    const QPersistentModelIndex row(pulses_->selectionModel()->selectedRows().front());
    menu->addSeparator();
    menu->addAction(tr("Type its MEP\u2026"), this, [this, row] { typeMep(row); });
    menu->addAction(tr("Show in the replay"), this, [this, row] {
      if (row.isValid()) presenter_.mark(table_->numberAt(sorted_->mapToSource(row).row()));
      emit replayWanted();
    });
  }
  menu->popup(pulses_->viewport()->mapToGlobal(at));
}

void SessionsPanel::typeMep(const QModelIndex& row) {
  const auto mep = row.siblingAtColumn(PulseTable::columnOf(report::PulseColumn::mep));
  if (!mep.isValid()) return;
  pulses_->setFocus();
  pulses_->setCurrentIndex(mep);
  pulses_->edit(mep);
}

/// Excludes the chosen pulses for the typed reason; asks for one if none is typed.
void SessionsPanel::excludeChosen() {
  if (!reason_->text().trimmed().isEmpty()) return exclude_->click();
  auto* question = new QInputDialog(this);
  question->setObjectName("exclude_question");
  question->setAttribute(Qt::WA_DeleteOnClose);
  question->setWindowTitle(tr("Exclude pulses"));
  question->setLabelText(tr("Reason to exclude the chosen pulses. They count no more; nothing is deleted."));
  connect(question, &QInputDialog::textValueSelected, this,
          [this, numbers = chosen(false)](const QString& reason) {
            presenter_.exclude(numbers, reason, by_->text());
          });
  question->open();
}

QWidget* SessionsPanel::makeEdits() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  auto* fields = new QHBoxLayout;
  reason_ = new QLineEdit(box);
  reason_->setAccessibleName(tr("reason to exclude"));
  reason_->setPlaceholderText(tr("reason to exclude"));
  reason_->setToolTip(tr("why the chosen pulses do not count; kept with the change"));
  by_ = new QLineEdit(box);
  by_->setAccessibleName(tr("your name or initials"));
  by_->setPlaceholderText(tr("by"));
  by_->setToolTip(tr("your name or initials; kept with the change"));
  whenTextScales(this, [this] { by_->setMaximumWidth(sized(90)); });
  fields->addWidget(reason_, 1);
  fields->addWidget(by_);
  auto* buttons = new QHBoxLayout;
  const auto button = [&](const QString& text, const QString& tip, auto action) {
    auto* made = new QPushButton(text, box);
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, action);
    buttons->addWidget(made);
    return made;
  };
  exclude_ = button(tr("Exclude"), tr("they count no more; nothing is deleted"),
                    [this] { presenter_.exclude(chosen(false), reason_->text(), by()); });
  include_ =
      button(tr("Take in"), tr("they count again"), [this] { presenter_.include(chosen(true), by()); });
  buttons->addStretch(1);
  undo_ = button(tr("Undo"), {}, [this] { presenter_.undo(); });
  redo_ = button(tr("Redo"), {}, [this] { presenter_.redo(); });
  const auto key = [this](const QKeySequence& keys, const QString& words, auto action) {
    auto* shortcut = new QShortcut(keys, this);
    shortcut->setWhatsThis(words);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  key(QKeySequence::Undo, tr("undo a change to the pulses"), [this] { presenter_.undo(); });
  key(QKeySequence::Redo, tr("redo a change to the pulses"), [this] { presenter_.redo(); });
  connect(reason_, &QLineEdit::textChanged, this, &SessionsPanel::showState);
  column->addLayout(fields);
  column->addLayout(buttons);
  return box;
}

/// Who changes the pulses; remembered for the other fields that ask.
QString SessionsPanel::by() const {
  rememberAuthor(by_->text());
  return by_->text();
}

void SessionsPanel::showSessions() {
  if (by_->text().isEmpty()) by_->setText(author());
  is_filling_ = true;
  const auto& sessions = presenter_.sessions();
  sessions_->setRowCount(int(sessions.size()));
  for (int row = 0; row < int(sessions.size()); ++row) {
    const auto& s = sessions[sessions.size() - 1 - std::size_t(row)];  // newest first
    const int counted = s.pulses - s.excluded;
    const QStringList texts{
        (s.is_at_home ? tr("%1 home") : QString("%1"))
            .arg(QString::fromStdString(report::localTime(s.started_utc)).left(kToTheMinute)),
        s.excluded ? tr("%1 (%2)").arg(s.pulses).arg(s.excluded) : QString::number(s.pulses),
        counted > 0 ? tr("%1 %").arg(100.0 * s.on_target / counted, 0, 'f', 0) : QString::fromUtf8("\u2013"),
        spread(s.distance_mm),
        minutes(s.lost_s),
        minutes(s.off_target_s),
        s.error_bound_mm ? QString::number(*s.error_bound_mm, 'f', 1) : QString::fromUtf8("\u2013")};
    for (int i = 0; i < texts.size(); ++i) {
      auto* item = new QTableWidgetItem(texts[i]);
      if (i == 0) item->setData(Qt::UserRole, QString::fromStdString(s.name));
      if (i == 0) item->setToolTip(QString::fromStdString(report::localTimeAndZone(s.started_utc)));
      if (!s.problems.empty()) item->setToolTip(shownWords(s.problems.front()));
      sessions_->setItem(row, i, item);
    }
  }
  is_filling_ = false;
  showState();
}

/// Shows the presenter's choice; the presenter chooses the newest session by itself.
void SessionsPanel::showChosen() {
  is_filling_ = true;
  for (int row = 0; row < sessions_->rowCount(); ++row)
    if (sessions_->item(row, 0)->data(Qt::UserRole).toString() == presenter_.chosen() &&
        sessions_->currentRow() != row)
      sessions_->setCurrentCell(row, 0);
  is_filling_ = false;
}

/// Numbers of the selected pulses in that state.
std::vector<int> SessionsPanel::chosen(bool are_excluded) const {
  std::vector<int> numbers;
  for (const auto& row : pulses_->selectionModel()->selectedRows()) {
    const int at = sorted_->mapToSource(row).row();
    if (table_->isExcluded(at) == are_excluded) numbers.push_back(table_->numberAt(at));
  }
  return numbers;
}

void SessionsPanel::showState() {
  const auto session = presenter_.session();
  showChosen();
  if (presenter_.sessions().empty()) {
    words_->setText(tr("This case has no sessions yet: treat it first."));
  } else if (!session) {
    words_->setText(tr("reading the session"));
  } else {
    const auto summary = report::summarise(session->kept);
    QStringList words{shownWords(summary.end)};
    if (summary.is_at_home) words << tr("at home");
    if (summary.alignment) words << shownWords(*summary.alignment);
    for (const auto& caution : summary.alignment_cautions)
      words << tr("caution: %1").arg(shownWords(caution));
    words << tr("losses: face %1, coil %2").arg(summary.face_losses).arg(summary.coil_losses);
    if (summary.adverse_events) words << tr("adverse events: %1").arg(summary.adverse_events);
    if (!summary.problems.empty()) words << shownWords(summary.problems.front());
    words_->setText(words.join(tr("; ")));
  }
  if (!pulses_->selectionModel()) return;
  const bool has_reason = !reason_->text().trimmed().isEmpty();
  exclude_->setEnabled(has_reason && !chosen(false).empty());
  include_->setEnabled(!chosen(true).empty());
  undo_->setEnabled(presenter_.editor().canUndo());
  redo_->setEnabled(presenter_.editor().canRedo());
  undo_->setToolTip(tr("%1 (Ctrl+Z)").arg(shownWords(presenter_.editor().undoWords())));
  redo_->setToolTip(tr("%1 (Ctrl+Shift+Z)").arg(shownWords(presenter_.editor().redoWords())));
}

void SessionsPanel::showMarked() {
  const auto current = pulses_->currentIndex();
  if (current.isValid() && table_->numberAt(sorted_->mapToSource(current).row()) == presenter_.marked())
    return;
  for (int row = 0; row < sorted_->rowCount(); ++row)
    if (table_->numberAt(sorted_->mapToSource(sorted_->index(row, 0)).row()) == presenter_.marked())
      return pulses_->selectRow(row);
}

}  // namespace facenav::ui
