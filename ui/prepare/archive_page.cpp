#include "prepare/archive_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QTableWidget>
#include <QVBoxLayout>

#include "prepare/archive_settings.h"
#include "shell/appearance.h"
#include "shell/scroll_column.h"

namespace facenav::ui {
namespace {

enum Column { date, modality, study, description, images, patient, columns };

}  // namespace

ArchivePage::ArchivePage(ArchivePresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter), table_(new QTableWidget(0, columns, this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  auto* column = new QVBoxLayout;
  column->addWidget(makeQuery());
  table_->setHorizontalHeaderLabels(
      {tr("Date"), tr("Kind"), tr("Study"), tr("Series"), tr("Images"), tr("Patient")});
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setShowGrid(false);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->setAccessibleName(tr("series in the archive"));
  table_->setToolTip(tr("double click: fetch"));
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setStretchLastSection(true);
  whenTextScales(this, [this] {
    const int widths[] = {110, 60, 220, 260, 80};
    for (int i = 0; i < patient; ++i) table_->setColumnWidth(i, sized(widths[i]));
  });
  column->addWidget(table_, 1);
  column->addWidget(makeFoot());
  row->addLayout(column, 1);
  row->addWidget(new ScrollColumn(new ArchiveSettings(presenter_, this), 370, this));
  connect(&presenter_, &ArchivePresenter::found, this, &ArchivePage::showFound);
  connect(&presenter_, &ArchivePresenter::changed, this, &ArchivePage::showState);
  connect(&presenter_, &ArchivePresenter::queued, this, &ArchivePage::queued);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &ArchivePage::showState);
  connect(table_, &QTableWidget::itemDoubleClicked, this, [this] { presenter_.fetch(table_->currentRow()); });
  showFound();
  showState();
}

QWidget* ArchivePage::makeQuery() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  const auto field = [&](const QString& hint, const QString& tip) {
    auto* made = new QLineEdit(box);
    made->setPlaceholderText(hint);
    made->setToolTip(tip);
    made->setAccessibleName(hint);
    row->addWidget(made, 1);
    connect(made, &QLineEdit::returnPressed, this, &ArchivePage::find);
    return made;
  };
  patient_id_ = field(tr("patient ID"), tr("* and ? stand for anything"));
  patient_name_ = field(tr("name"), tr("FAMILY^GIVEN as the archive writes it; * and ? stand for anything"));
  date_ = field(tr("date"), tr("YYYYMMDD, or from-to: YYYYMMDD-YYYYMMDD"));
  modality_ = new QComboBox(box);
  modality_->setAccessibleName(tr("kind of image"));
  modality_->addItem(tr("MR"), "MR");
  modality_->addItem(tr("CT"), "CT");
  modality_->addItem(tr("any kind"), "");
  modality_->setToolTip(tr("kind of image"));
  find_ = new QPushButton(tr("Find"), box);
  find_->setObjectName("primary");
  find_->setToolTip(tr("ask the archive (Return in a field)"));
  row->addWidget(modality_);
  row->addWidget(find_);
  connect(find_, &QPushButton::clicked, this, &ArchivePage::find);
  return box;
}

QWidget* ArchivePage::makeFoot() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  fetch_ = new QPushButton(tr("Fetch and prepare"), box);
  fetch_->setObjectName("primary");
  fetch_->setToolTip(tr("bring the chosen series here and queue it (Ctrl+Return)"));
  fetch_->setShortcut(Qt::CTRL + Qt::Key_Return);
  cancel_ = new QPushButton(tr("Cancel"), box);
  cancel_->setToolTip(tr("stop; nothing half-fetched is kept"));
  auto* back = new QPushButton(tr("Back"), box);
  back->setToolTip(tr("to the series page (Alt+2)"));
  shows_patient_ = new QCheckBox(tr("show patients"), box);
  shows_patient_->setToolTip(tr("patient ID and name in the list; hidden otherwise"));
  whenTextScales(box, [this, back] { shows_patient_->setMinimumHeight(back->sizeHint().height()); });
  words_ = new QLabel(box);
  words_->setObjectName("taskwords");
  words_->setWordWrap(true);
  for (QWidget* each : {static_cast<QWidget*>(fetch_), static_cast<QWidget*>(cancel_),
                        static_cast<QWidget*>(back), static_cast<QWidget*>(shows_patient_)})
    row->addWidget(each, 0, Qt::AlignBottom);  // where they are, however many lines the words take
  row->addWidget(words_, 1);
  connect(fetch_, &QPushButton::clicked, this, [this] { presenter_.fetch(table_->currentRow()); });
  connect(cancel_, &QPushButton::clicked, &presenter_, &ArchivePresenter::cancel);
  connect(back, &QPushButton::clicked, this, &ArchivePage::left);
  connect(shows_patient_, &QCheckBox::toggled, this, &ArchivePage::showFound);
  return box;
}

void ArchivePage::find() {
  pacs::PacsQuery query;
  query.patient_id = patient_id_->text().trimmed().toStdString();
  query.patient_name = patient_name_->text().trimmed().toStdString();
  query.study_date = date_->text().trimmed().toStdString();
  query.modality = modality_->currentData().toString().toStdString();
  presenter_.find(query);
}

void ArchivePage::showFound() {
  table_->setColumnHidden(patient, !shows_patient_->isChecked());
  table_->setRowCount(int(presenter_.series().size()));
  int line = 0;
  for (const auto& series : presenter_.series()) {
    const std::string cells[columns] = {series.date,
                                        series.modality,
                                        series.study_description,
                                        series.description,
                                        series.images > 0 ? std::to_string(series.images) : std::string("?"),
                                        series.patient_id + "  " + series.patient_name};
    for (int i = 0; i < columns; ++i)
      table_->setItem(line, i, new QTableWidgetItem(QString::fromStdString(cells[i])));
    ++line;
  }
  if (line > 0 && table_->currentRow() < 0) table_->selectRow(0);
}

void ArchivePage::showState() {
  const bool is_busy = presenter_.isBusy();
  find_->setEnabled(!is_busy);
  fetch_->setEnabled(!is_busy && table_->currentRow() >= 0);
  cancel_->setEnabled(is_busy);  // grey, not gone: the others keep their places
  words_->setText(presenter_.words());
  const char* name = presenter_.isFault() ? "fault" : "muted";
  if (words_->objectName() != name) {
    words_->setObjectName(name);
    words_->style()->unpolish(words_);
    words_->style()->polish(words_);
  }
}

}  // namespace facenav::ui
