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
#include <utility>

#include "facenav/report/local_time.h"
#include "plan/other_words.h"
#include "shell/field_label.h"
#include "shell/help_window.h"
#include "shell/narrow_label.h"
#include "shell/work_area.h"

namespace facenav::ui {
namespace {

constexpr QSize kExportSize{680, 520};
constexpr const char* kEverySession = "*";  // beside the names of sessions; never one of them

}  // namespace

ExportWindow::ExportWindow(CaseModel& model, const QString& session, ExportPresenter::SendToArchive send,
                           QWidget* parent)
    : QWidget(parent, Qt::Window), presenter_(model, std::move(send)) {
  setWindowTitle(tr("FaceNav: export for another program"));
  setAttribute(Qt::WA_DeleteOnClose);
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  makeFields(*grid);
  makeSource(*grid);
  makeFile(*grid);
  column->addLayout(grid, 1);
  words_ = new QLabel(this);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  makeNarrow(*words_);
  column->addWidget(words_);
  column->addWidget(makeButtons());
  auto* leave = new QShortcut(Qt::Key_Escape, this);
  leave->setWhatsThis(tr("close the window of the export"));
  connect(leave, &QShortcut::activated, this, &QWidget::close);
  HelpWindow::addKey(*this, "interop.md", "in-the-window");
  connectPresenter(model);
  fill(session);
  fitIntoWorkArea(*this, kExportSize);
}

QWidget* ExportWindow::makeButtons() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  close_ = new QPushButton(tr("Close"), bar);
  close_->setToolTip(tr("Esc"));
  write_ = new QPushButton(tr("&Write"), bar);
  write_->setObjectName("primary");
  write_->setToolTip(tr("writes the file, readable for you alone (Ctrl+Return)"));
  write_->setShortcut(Qt::CTRL + Qt::Key_Return);
  row->addStretch(1);
  row->addWidget(close_);
  row->addWidget(write_);
  connect(close_, &QPushButton::clicked, this, &QWidget::close);
  connect(write_, &QPushButton::clicked, this, &ExportWindow::write);
  return bar;
}

void ExportWindow::connectPresenter(CaseModel& model) {
  connect(&presenter_, &ExportPresenter::refused, this, [this](const QString& words) {
    say(words, true);
    write_->setEnabled(true);
  });
  connect(&presenter_, &ExportPresenter::progressed, this,
          [this](const QString& words) { say(words, false); });
  connect(&presenter_, &ExportPresenter::written, this, [this](const QString& words) {
    tell(words);
    write_->setEnabled(true);
  });
  connect(&model, &CaseModel::opened, this, &QWidget::close);
}

void ExportWindow::makeFields(QGridLayout& grid) {
  formats_ = new QComboBox(this);
  formats_->setToolTip(tr("the program that shall read the file, and what its file holds"));
  formats_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  formats_->setMinimumContentsLength(20);
  for (const auto* format : presenter_.formats()) formats_->addItem(inWindowWords(format->words));
  formats_->addItem(tr("DICOM: the MRI with targets and coils drawn into it, a series for the archive"));
  formats_->addItem(tr("DICOM: targets and coils as segments beside the scan, one object"));
  formats_->addItem(tr("DICOM: the report of a session as a document, one object"));
  targets_ = new QListWidget(this);
  targets_->setToolTip(tr("Space: take the target or leave it out"));
  pulses_ = new QComboBox(this);
  pulses_->setToolTip(tr("the session whose pulses go into the file"));
  grid.addWidget(fieldLabel(tr("&Format"), formats_, this), 0, 0);
  grid.addWidget(formats_, 0, 1, 1, 2);
  grid.addWidget(fieldLabel(tr("&Targets"), targets_, this), 1, 0, Qt::AlignTop);
  grid.addWidget(targets_, 1, 1, 1, 2);
  grid.addWidget(fieldLabel(tr("&Pulses"), pulses_, this), 2, 0);
  grid.addWidget(pulses_, 2, 1, 1, 2);
  grid.setRowStretch(1, 1);
  connect(formats_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportWindow::showFormat);
  connect(pulses_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportWindow::showFormat);
}

void ExportWindow::makeSource(QGridLayout& grid) {
  source_ = new QLineEdit(this);
  source_->setToolTip(
      tr("the folder of the DICOM files that the case was prepared from; patient and study are taken from "
         "there"));
  source_->setPlaceholderText(tr("folder of the original DICOM files"));
  choose_source_ = new QPushButton(tr("C&hoose\u2026"), this);
  choose_source_->setToolTip(tr("where the original DICOM files are"));
  source_label_ = fieldLabel(tr("&Source"), source_, this);
  grid.addWidget(source_label_, 3, 0);
  grid.addWidget(source_, 3, 1);
  grid.addWidget(choose_source_, 3, 2);
  connect(choose_source_, &QPushButton::clicked, this, &ExportWindow::chooseSource);
}

void ExportWindow::makeFile(QGridLayout& grid) {
  file_ = new QLineEdit(this);
  file_->setObjectName("export_file");
  file_->setToolTip(tr("the name says nothing of the patient unless you type it"));
  auto* choose = new QPushButton(tr("&Choose\u2026"), this);
  choose->setToolTip(tr("where the file goes"));
  replaces_ = new QCheckBox(tr("&Replace a file of this name"), this);
  sends_ = new QCheckBox(tr("Send it to the &archive, %1").arg(presenter_.archiveWords()), this);
  sends_->setToolTip(tr("after it is written; the archive is set up in Prepare, page Archive"));
  grid.addWidget(fieldLabel(tr("F&ile"), file_, this), 4, 0);
  grid.addWidget(file_, 4, 1);
  grid.addWidget(choose, 4, 2);
  grid.addWidget(replaces_, 5, 1, 1, 2);
  grid.addWidget(sends_, 6, 1, 1, 2);
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

std::optional<DicomKind> ExportWindow::dicom() const {
  const int behind = formats_->currentIndex() - int(presenter_.formats().size());
  return behind >= 0 ? std::optional(DicomKind(behind)) : std::nullopt;
}

const interop::Format& ExportWindow::format() const {
  return *presenter_.formats()[std::size_t(std::max(0, formats_->currentIndex()))];
}

/// Offers what the format can hold, and its usual file.
void ExportWindow::showFormat() {
  say({}, false);
  const auto kind = dicom();
  for (QWidget* of_dicom : {static_cast<QWidget*>(source_label_), static_cast<QWidget*>(source_),
                            static_cast<QWidget*>(choose_source_)})
    of_dicom->setVisible(kind.has_value());
  sends_->setVisible(kind && !presenter_.archiveWords().isEmpty());
  if (kind) return showDicom(*kind);
  const bool holds_pulses = format().holds_pulses && pulses_->count() > 2;
  const bool is_one_kind = steps::holdsOneKind(format().name);
  pulses_->setEnabled(holds_pulses);
  if (is_one_kind && pulses_->currentData() == kEverySession) pulses_->setCurrentIndex(0);
  targets_->setEnabled(!(is_one_kind && holds_pulses && pulses_->currentIndex() > 0));
  if (!is_file_chosen_) file_->setText(presenter_.usualFile(format()));
}

/// A report is that of one session; the plan is that of the targets.
void ExportWindow::showDicom(DicomKind kind) {
  const bool is_report = kind == DicomKind::report;
  targets_->setEnabled(!is_report);
  pulses_->setEnabled(is_report && pulses_->count() > 2);
  if (pulses_->isEnabled() && pulses_->currentIndex() < 2) pulses_->setCurrentIndex(2);  // the newest
  if (!is_file_chosen_) file_->setText(presenter_.usualFile(kind));
  say(tr("What is written names the patient, as the original files do."), false);
}

std::vector<std::string> ExportWindow::ticked() const {
  std::vector<std::string> names;
  for (int i = 0; i < targets_->count(); ++i)
    if (targets_->item(i)->checkState() == Qt::Checked)
      names.push_back(targets_->item(i)->text().toStdString());
  return names;
}

/// Names the ticked targets; all of them are no names only where the pulses of all sessions are wanted, too.
steps::OtherExport ExportWindow::order() const {
  steps::OtherExport order;
  if (!dicom()) order.format = format().name;
  order.output = file_->text().trimmed().toStdString();
  order.replaces = replaces_->isChecked();
  const QString pulses = pulses_->isEnabled() ? pulses_->currentData().toString() : QString();
  if (pulses != kEverySession) order.session = pulses.toStdString();
  order.targets = ticked();
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

void ExportWindow::chooseSource() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder of the original DICOM files"), source_->text());
  if (!folder.isEmpty()) source_->setText(folder);
}

void ExportWindow::write() {
  if (presenter_.isWriting()) return;
  if (const auto kind = dicom()) return writeDicom(*kind);
  const auto wanted = order();
  if (targets_->isEnabled() && wanted.targets.empty()) return say(tr("tick a target first"), true);
  if (wanted.output.empty()) return say(tr("name the file first"), true);
  const QString words = presenter_.write(wanted);
  if (!words.isEmpty()) tell(words);
}

void ExportWindow::writeDicom(DicomKind kind) {
  const auto wanted = order();
  DicomWish wish{kind,
                 {wanted.targets, source_->text().trimmed().toStdString(), wanted.output, wanted.replaces}};
  if (kind == DicomKind::report) wish.session = pulses_->currentData().toString();
  wish.is_sent = sends_->isVisibleTo(this) && sends_->isChecked();
  if (kind == DicomKind::report && !pulses_->isEnabled()) return say(tr("the case has no session yet"), true);
  if (targets_->isEnabled() && wanted.targets.empty()) return say(tr("tick a target first"), true);
  if (wish.order.source.empty()) return say(tr("name the folder of the original DICOM files first"), true);
  if (wanted.output.empty()) return say(tr("name the file first"), true);
  write_->setEnabled(false);
  say(tr("writing"), false);
  presenter_.writeDicom(wish);
}

void ExportWindow::tell(const QString& words) {
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
