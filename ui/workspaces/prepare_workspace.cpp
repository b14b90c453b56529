#include "workspaces/prepare_workspace.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "views/linked_views.h"

namespace facenav::ui {
namespace {

QLabel* heading(const QString& words, QWidget* parent) {
  auto* label = new QLabel(words, parent);
  label->setObjectName("heading");
  return label;
}

}  // namespace

PrepareWorkspace::PrepareWorkspace(PreparePresenter& presenter, CaseModel& model, QWidget* parent)
    : QWidget(parent), presenter_(presenter), model_(model), views_(new LinkedViews(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 10, 10, 10);
  row->addWidget(makeSeriesPanel());
  row->addWidget(views_, 1);
  row->addWidget(makeFindingsPanel());
  connect(&presenter_, &PreparePresenter::linesChanged, this, &PrepareWorkspace::showLines);
  connect(&model_, &CaseModel::opened, this, [this] {
    is_outdated_ = true;
    if (isVisible()) showCase();
  });
}

QWidget* PrepareWorkspace::makeSeriesPanel() {
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  panel->setFixedWidth(280);
  auto* column = new QVBoxLayout(panel);
  auto* folder = new QPushButton(tr("Read DICOM folder\u2026"), panel);
  auto* file = new QPushButton(tr("Read NIfTI file\u2026"), panel);
  folder->setToolTip(tr("list the series under a folder (Ctrl+I); or drop a folder anywhere"));
  prepare_ = new QPushButton(tr("Prepare case\u2026"), panel);
  prepare_->setObjectName("primary");
  prepare_->setToolTip(tr("model skin and brain of the chosen series (Ctrl+Return)"));
  prepare_->setShortcut(Qt::CTRL + Qt::Key_Return);
  prepare_->setEnabled(false);
  series_ = new QListWidget(panel);
  series_->setWordWrap(true);
  column->addWidget(heading(tr("Series"), panel));
  column->addWidget(folder);
  column->addWidget(file);
  column->addWidget(series_, 1);
  column->addWidget(prepare_);
  connect(folder, &QPushButton::clicked, this, &PrepareWorkspace::chooseInput);
  connect(file, &QPushButton::clicked, this, [this] {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Read NIfTI"), {}, tr("NIfTI (*.nii *.nii.gz)"));
    if (!path.isEmpty()) presenter_.openInput(path);
  });
  connect(prepare_, &QPushButton::clicked, this, &PrepareWorkspace::prepareChosen);
  connect(series_, &QListWidget::currentRowChanged, this, [this](int line) {
    prepare_->setEnabled(line >= 0 && presenter_.lines()[std::size_t(line)].is_usable);
  });
  return panel;
}

QWidget* PrepareWorkspace::makeFindingsPanel() {
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  panel->setFixedWidth(270);
  auto* column = new QVBoxLayout(panel);
  findings_ = new QListWidget(panel);
  findings_->setWordWrap(true);
  findings_->setFocusPolicy(Qt::NoFocus);
  findings_->setSelectionMode(QAbstractItemView::NoSelection);
  auto* masks = new QCheckBox(tr("mask contours"), panel);
  masks->setChecked(true);
  masks->setToolTip(tr("skin orange, brain blue (M)"));
  masks->setShortcut(Qt::Key_M);
  connect(masks, &QCheckBox::toggled, views_, &LinkedViews::setMasksShown);
  column->addWidget(heading(tr("Findings"), panel));
  column->addWidget(findings_, 1);
  column->addWidget(masks);
  return panel;
}

void PrepareWorkspace::chooseInput() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Read DICOM folder"));
  if (!folder.isEmpty()) presenter_.openInput(folder);
}

void PrepareWorkspace::showLines() {
  series_->clear();
  for (const auto& line : presenter_.lines()) {
    const QString mark = line.is_recommended ? tr("\u2605 ") : line.is_usable ? QString() : tr("\u2715 ");
    auto* item = new QListWidgetItem(mark + line.title + "\n" + line.detail, series_);
    if (!line.is_usable) item->setForeground(QColor(140, 148, 158));
  }
  series_->setCurrentRow(presenter_.recommendedLine());
}

void PrepareWorkspace::prepareChosen() {
  const QString folder = QFileDialog::getSaveFileName(this, tr("Folder for the new case"), "case", {},
                                                      nullptr, QFileDialog::DontConfirmOverwrite);
  if (!folder.isEmpty()) presenter_.prepare(series_->currentRow(), folder);
}

void PrepareWorkspace::showCase() {
  if (!is_outdated_ || !model_.isOpen()) return;
  is_outdated_ = false;
  views_->show(model_.current());
  findings_->clear();
  for (const auto& line : presenter_.findings()) {
    auto* item = new QListWidgetItem((line.is_caution ? tr("!  ") : tr("\u2713  ")) + line.words, findings_);
    item->setForeground(line.is_caution ? QColor(255, 178, 92) : QColor(210, 220, 228));
  }
}

void PrepareWorkspace::showEvent(QShowEvent*) { showCase(); }

}  // namespace facenav::ui
