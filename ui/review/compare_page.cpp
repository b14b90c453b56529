#include "review/compare_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "facenav/report/local_time.h"
#include "shell/appearance.h"
#include "shell/narrow_label.h"

namespace facenav::ui {
namespace {

QString number(double value, int decimals) { return QString::number(value, 'f', decimals); }

QString meanWords(const steps::MeanCoil& mean) {
  return QObject::tr("%1 pulses, \u00b1%2 mm, \u00b1%3\u00b0")
      .arg(mean.pulses)
      .arg(mean.spread_mm, 0, 'f', 1)
      .arg(mean.spread_deg, 0, 'f', 1);
}

QString namesOf(const std::vector<std::string>& names) {
  QStringList list;
  for (const auto& name : names) list << QString::fromStdString(name);
  return list.join(", ");
}

/// Rows of the table, one per figure, so that long names and doubled text stay readable.
std::vector<std::pair<QString, QString>> rowsOf(const steps::TargetReturn& back) {
  std::vector<std::pair<QString, QString>> rows{
      {QObject::tr("Return error: coil's centre"), number(back.distance_mm, 2) + " mm"},
      {QObject::tr("Return error: tilt"), number(back.tilt_deg, 2) + QString::fromUtf8("\u00b0")},
      {QObject::tr("Return error: handle turned"), number(back.twist_deg, 2) + QString::fromUtf8("\u00b0")},
      {QObject::tr("Return error: whole rotation"), number(back.angle_deg, 2) + QString::fromUtf8("\u00b0")},
      {QObject::tr("Pulses of the other session"), meanWords(back.first)},
      {QObject::tr("Pulses of the chosen session"), meanWords(back.second)},
      {QObject::tr("The target itself moved between them"), number(back.target_moved_mm, 2) + " mm, " +
                                                                number(back.target_turned_deg, 2) +
                                                                QString::fromUtf8("\u00b0")}};
  if (back.mep_first_uv && back.mep_second_uv)
    rows.emplace_back(QObject::tr("Median MEP"), number(*back.mep_first_uv, 0) +
                                                     QString::fromUtf8(" \u2192 ") +
                                                     number(*back.mep_second_uv, 0) + " uV");
  return rows;
}

}  // namespace

ComparePage::ComparePage(ReviewPresenter& presenter, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      earlier_(new QComboBox(this)),
      table_(new QTableWidget(this)),
      words_(new QLabel(this)) {
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("The chosen session against"), this));
  row->addWidget(earlier_, 1);
  earlier_->setAccessibleName(tr("session to compare with"));
  table_->setAccessibleName(tr("differences of the sessions"));
  earlier_->setToolTip(tr("the session that the coil had to come back to"));
  earlier_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  earlier_->setMinimumContentsLength(16);
  words_->setObjectName("muted");
  makeNarrow(*words_);
  table_->setColumnCount(3);
  table_->setHorizontalHeaderLabels({tr("target"), tr("figure"), tr("value")});
  table_->verticalHeader()->hide();
  whenTextScales(this, [this] { table_->verticalHeader()->setDefaultSectionSize(sized(30)); });
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setShowGrid(false);
  table_->setTabKeyNavigation(false);  // Tab leaves the table
  table_->setAlternatingRowColors(true);
  whenTextScales(this, [this] {
    table_->setColumnWidth(0, sized(150));
    table_->setColumnWidth(1, sized(260));
  });
  table_->horizontalHeader()->setStretchLastSection(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(table_, 1);
  column->addWidget(words_);
  connect(&presenter_, &ReviewPresenter::sessionsChanged, this, &ComparePage::showSessions);
  connect(&presenter_, &ReviewPresenter::sessionChanged, this, &ComparePage::showSessions);
  connect(earlier_, QOverload<int>::of(&QComboBox::activated), this, &ComparePage::showComparison);
}

void ComparePage::showSessions() {
  if (!isVisible()) return;
  const QString before = earlier_->currentText();
  earlier_->clear();
  const auto& sessions = presenter_.sessions();
  for (auto s = sessions.rbegin(); s != sessions.rend(); ++s)
    if (QString::fromStdString(s->name) != presenter_.chosen())
      earlier_->addItem(QString::fromStdString(report::localTime(s->name)), QString::fromStdString(s->name));
  earlier_->setCurrentText(before);
  showComparison();
}

void ComparePage::showComparison() {
  table_->setRowCount(0);
  if (earlier_->count() == 0 || !presenter_.session())
    return words_->setText(earlier_->count() == 0 ? tr("The case has no other session.")
                                                  : tr("reading the session"));
  const auto comparison = presenter_.compareWith(earlier_->currentData().toString());
  if (!comparison) return words_->clear();
  for (const auto& back : comparison->targets) {
    bool is_first = true;
    for (const auto& [name, value] : rowsOf(back)) {
      const int line = table_->rowCount();
      table_->insertRow(line);
      const QString target = QString::fromStdString(back.target);
      const QString texts[] = {is_first ? target : QString(), name, value};
      for (int i = 0; i < 3; ++i) {
        auto* cell = new QTableWidgetItem(texts[i]);
        cell->setToolTip(i == 0 ? target : texts[i]);
        table_->setItem(line, i, cell);
      }
      is_first = false;
    }
  }
  constexpr int kLongestTarget_px = 120;
  for (int column = 0; column < 2; ++column) table_->resizeColumnToContents(column);
  table_->setColumnWidth(0, std::min(table_->columnWidth(0), sized(kLongestTarget_px)));  // its tip is whole
  QStringList words{tr(
      "Mean pose of the coil over the pulses that are not excluded, in the MRI; \u00b1: root mean square.")};
  if (comparison->targets.empty()) words << tr("No target has pulses in both sessions.");
  if (!comparison->only_first.empty())
    words << tr("Only in the other: %1.").arg(namesOf(comparison->only_first));
  if (!comparison->only_second.empty())
    words << tr("Only in the chosen: %1.").arg(namesOf(comparison->only_second));
  words_->setText(words.join(" "));
}

void ComparePage::showEvent(QShowEvent*) { showSessions(); }

}  // namespace facenav::ui
