#include "plan/export_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "facenav/report/local_time.h"
#include "plan/other_words.h"
#include "shell/help_window.h"
#include "shell/narrow_label.h"
#include "shell/work_area.h"

namespace facenav::ui {
namespace {

constexpr QSize kExportSize{680, 520};
constexpr const char* kEverySession = "*";  // beside the names of sessions; never one of them

QLabel* exportLabel(const QString& words, QWidget* field, QWidget* parent) {
  auto* label = new QLabel(words, parent);
  label->setBuddy(field);
  field->setAccessibleName(QString(words).remove('&'));
  return label;
}

}  // namespace

ExportWindow::ExportWindow(CaseModel& model, const QString& session, QWidget* parent)
    : QWidget(parent, Qt::Window), presenter_(model) {
  setWindowTitle(tr("FaceNav: export for another program"));
  setAttribute(Qt::WA_DeleteOnClose);
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  makeFields(*grid);
  makeFile(*grid);
  column->addLayout(grid, 1);
  words_ = new QLabel(this);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  makeNarrow(*words_);
  column->addWidget(words_);
  auto* row = new QHBoxLayout;
  auto* close_it = new QPushButton(tr("Close"), this);
  close_it->setToolTip(tr("Esc"));
  write_ = new QPushButton(tr("&Write"), this);
  write_->setObjectName("primary");
  write_->setToolTip(tr("writes the file, readable for you alone (Ctrl+Return)"));
  write_->setShortcut(Qt::CTRL + Qt::Key_Return);
  row->addStretch(1);
  row->addWidget(close_it);
  row->addWidget(write_);
  column->addLayout(row);
  connect(close_it, &QPushButton::clicked, this, &QWidget::close);
  connect(write_, &QPushButton::clicked, this, &ExportWindow::write);
  auto* leave = new QShortcut(Qt::Key_Escape, this);
  leave->setWhatsThis(tr("close the window of the export"));
  connect(leave, &QShortcut::activated, this, &QWidget::close);
  HelpWindow::addKey(*this, "interop.md", "in-the-window");
  connect(&presenter_, &ExportPresenter::refused, this, [this](const QString& words) { say(words, true); });
  connect(&model, &CaseModel::opened, this, &QWidget::close);
  fill(session);
  fitIntoWorkArea(*this, kExportSize);
}

void ExportWindow::makeFields(QGridLayout& grid) {
  formats_ = new QComboBox(this);
  formats_->setToolTip(tr("the program that shall read the file, and what its file holds"));
  formats_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  formats_->setMinimumContentsLength(20);
  for (const auto* format : presenter_.formats()) formats_->addItem(inWindowWords(format->words));
  targets_ = new QListWidget(this);
  targets_->setToolTip(tr("Space: take the target or leave it out"));
  pulses_ = new QComboBox(this);
  pulses_->setToolTip(tr("the session whose pulses go into the file"));
  grid.addWidget(exportLabel(tr("&Format"), formats_, this), 0, 0);
  grid.addWidget(formats_, 0, 1, 1, 2);
  grid.addWidget(exportLabel(tr("&Targets"), targets_, this), 1, 0, Qt::AlignTop);
  grid.addWidget(targets_, 1, 1, 1, 2);
  grid.addWidget(exportLabel(tr("&Pulses"), pulses_, this), 2, 0);
  grid.addWidget(pulses_, 2, 1, 1, 2);
  grid.setRowStretch(1, 1);
  connect(formats_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportWindow::showFormat);
  connect(pulses_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportWindow::showFormat);
}

void ExportWindow::makeFile(QGridLayout& grid) {
  file_ = new QLineEdit(this);
  file_->setToolTip(tr("the name says nothing of the patient unless you type it"));
  auto* choose = new QPushButton(tr("&Choose\u2026"), this);
  choose->setToolTip(tr("where the file goes"));
  replaces_ = new QCheckBox(tr("&Replace a file of this name"), this);
  grid.addWidget(exportLabel(tr("F&ile"), file_, this), 3, 0);
  grid.addWidget(file_, 3, 1);
  grid.addWidget(choose, 3, 2);
  grid.addWidget(replaces_, 4, 1, 1, 2);
  connect(file_, &QLineEdit::textEdited, this, [this] { is_file_chosen_ = true; });
  connect(choose, &QPushButton::clicked, this, &ExportWindow::chooseFile);
}

void ExportWindow::fill(const QString& session) {
  for (const QString& name : presenter_.targets()) {
    auto* item = new QListWidgetItem(name, targets_);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
  if (targets_->count() > 0) targets_->setCurrentRow(0);
  pulses_->addItem(tr("none"), QString());
  pulses_->addItem(tr("of all sessions"), kEverySession);
  for (const QString& name : presenter_.sessions())
    pulses_->addItem(tr("session %1").arg(QString::fromStdString(report::localTime(name.toStdString()))),
                     name);
  pulses_->setCurrentIndex(std::max(0, pulses_->findData(session)));
  showFormat();
}

const interop::Format& ExportWindow::format() const {
  return *presenter_.formats()[std::size_t(std::max(0, formats_->currentIndex()))];
}

/// Offers what the format can hold, and its usual file.
void ExportWindow::showFormat() {
  const bool holds_pulses = format().holds_pulses && pulses_->count() > 2;
  const bool is_one_kind = steps::holdsOneKind(format().name);
  pulses_->setEnabled(holds_pulses);
  if (is_one_kind && pulses_->currentData() == kEverySession) pulses_->setCurrentIndex(0);
  targets_->setEnabled(!(is_one_kind && holds_pulses && pulses_->currentIndex() > 0));
  if (!is_file_chosen_) file_->setText(presenter_.usualFile(format()));
  say({}, false);
}

/// Names the ticked targets; all of them are no names only where the pulses of all sessions are wanted, too.
steps::OtherExport ExportWindow::order() const {
  steps::OtherExport order;
  order.format = format().name;
  order.output = file_->text().trimmed().toStdString();
  order.replaces = replaces_->isChecked();
  const QString pulses = pulses_->isEnabled() ? pulses_->currentData().toString() : QString();
  if (pulses != kEverySession) order.session = pulses.toStdString();
  for (int i = 0; i < targets_->count(); ++i)
    if (targets_->item(i)->checkState() == Qt::Checked)
      order.targets.push_back(targets_->item(i)->text().toStdString());
  if (pulses == kEverySession) order.has_all_sessions = true;
  return order;
}

void ExportWindow::chooseFile() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Export for another program"), file_->text());
  if (file.isEmpty()) return;
  is_file_chosen_ = true;
  file_->setText(file);
  replaces_->setChecked(true);  // the dialog has asked
}

void ExportWindow::write() {
  const auto wanted = order();
  if (targets_->isEnabled() && wanted.targets.empty()) return say(tr("tick a target first"), true);
  if (wanted.output.empty()) return say(tr("name the file first"), true);
  const QString words = presenter_.write(wanted);
  if (words.isEmpty()) return;
  say(words, false);
  emit written(words.section('\n', 0, 0));
}

void ExportWindow::say(const QString& words, bool is_fault) {
  words_->setObjectName(is_fault ? "fault" : "said");
  words_->style()->unpolish(words_);
  words_->style()->polish(words_);
  words_->setText(words);
}

}  // namespace facenav::ui
