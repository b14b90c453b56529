#include "plan/field_import_window.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QStyle>
#include <QVBoxLayout>

#include "shell/field_label.h"
#include "shell/help_window.h"
#include "shell/narrow_label.h"
#include "shell/scroll_column.h"
#include "shell/users_words.h"
#include "shell/work_area.h"

namespace facenav::ui {
namespace {

constexpr QSize kFieldImportSize{680, 420};
constexpr double kLeastRate_A_per_us = 0.001, kMostRate_A_per_us = 1000;

}  // namespace

FieldImportWindow::FieldImportWindow(CaseModel& model, PlanPresenter& plan, bool may_be_scan, QWidget* parent)
    : QWidget(parent, Qt::Window), presenter_(model, plan) {
  setWindowTitle(tr("FaceNav: electric field from another program"));
  setAttribute(Qt::WA_DeleteOnClose);
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  makeAnswers(*grid);
  column->addLayout(grid);
  words_ = new QLabel(this);
  words_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  makeNarrow(*words_);
  column->addWidget(new ScrollColumn(words_, 0, this), 1);
  column->addWidget(makeButtons(may_be_scan));
  auto* leave = new QShortcut(Qt::Key_Escape, this);
  leave->setWhatsThis(tr("close; the field does not come in"));
  connect(leave, &QShortcut::activated, this, &QWidget::close);
  HelpWindow::addKey(*this, "field.md", "an-imported-field-tier-3");
  connect(&presenter_, &FieldImportPresenter::changed, this, &FieldImportWindow::showState);
  connect(&presenter_, &FieldImportPresenter::takenIn, this, [this](const QString& words) {
    emit takenIn(words);
    close();
  });
  connect(&model, &CaseModel::opened, this, &QWidget::close);
  fitIntoWorkArea(*this, kFieldImportSize);
}

void FieldImportWindow::makeAnswers(QGridLayout& grid) {
  file_ = new QLabel(this);
  file_->setObjectName("heading");
  makeNarrow(*file_);
  grid.addWidget(file_, 0, 0, 1, 3);
  target_ = new QComboBox(this);
  target_->setToolTip(tr("the target for whose pose the field was computed"));
  target_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  target_->setMinimumContentsLength(12);
  markUsersWords(*target_);
  rate_ = new QDoubleSpinBox(this);
  rate_->setRange(kLeastRate_A_per_us, kMostRate_A_per_us);
  rate_->setDecimals(3);
  rate_->setValue(1);
  rate_->setKeyboardTracking(false);
  rate_->setSuffix(tr(" A/\u00b5s"));
  rate_->setToolTip(tr("the rate of the current that the field is for; SimNIBS takes 1 A/\u00b5s"));
  grid.addWidget(fieldLabel(tr("&Target"), target_, this), 1, 0);
  grid.addWidget(target_, 1, 1, 1, 2);
  grid.addWidget(fieldLabel(tr("&Rate"), rate_, this), 2, 0);
  grid.addWidget(rate_, 2, 1, 1, 2);
  surface_ = addFile(grid, 3, tr("&Surface"), tr("the GIFTI surface that the values belong to"),
                     tr("Surface (*.gii)"), &FieldImportPresenter::setSurface);
  t1_ = addFile(grid, 4, tr("T&1"), tr("the NIfTI that the other program used; may stay empty"),
                tr("NIfTI (*.nii *.nii.gz)"), &FieldImportPresenter::setT1);
  connect(target_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { presenter_.setTarget(target_->currentText()); });
  connect(rate_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), &presenter_,
          &FieldImportPresenter::setRate);
}

QLineEdit* FieldImportWindow::addFile(QGridLayout& grid, int row, const QString& name, const QString& tip,
                                      const QString& kinds,
                                      void (FieldImportPresenter::*set)(const QString&)) {
  auto* path = new QLineEdit(this);
  path->setToolTip(tip);
  auto* choose = new QPushButton(tr("Choose\u2026"), this);
  choose->setToolTip(tip);
  auto* label = fieldLabel(name, path, this);
  grid.addWidget(label, row, 0);
  grid.addWidget(path, row, 1);
  grid.addWidget(choose, row, 2);
  connect(path, &QLineEdit::editingFinished, this, [this, path, set] {
    if (path->isModified()) (presenter_.*set)(path->text().trimmed());
    path->setModified(false);
  });
  connect(choose, &QPushButton::clicked, this, [this, path, tip, kinds, set] {
    const QString file = QFileDialog::getOpenFileName(this, tip, path->text(), kinds);
    if (file.isEmpty()) return;
    path->setText(file);
    (presenter_.*set)(file);
  });
  for (QWidget* each :
       {static_cast<QWidget*>(label), static_cast<QWidget*>(path), static_cast<QWidget*>(choose)})
    each->setProperty("row", row);
  return path;
}

QWidget* FieldImportWindow::makeButtons(bool may_be_scan) {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  auto* scan = new QPushButton(tr("It is a &scan"), bar);
  scan->setToolTip(tr("no field: prepares a case of it"));
  scan->setVisible(may_be_scan);
  auto* cancel = new QPushButton(tr("Cancel"), bar);
  cancel->setToolTip(tr("the field does not come in (Esc)"));
  take_in_ = new QPushButton(tr("&Bring in"), bar);
  take_in_->setObjectName("primary");
  take_in_->setToolTip(tr("keeps the field with the target; an earlier one is replaced (Ctrl+Return)"));
  take_in_->setShortcut(Qt::CTRL + Qt::Key_Return);
  row->addWidget(scan);
  row->addStretch(1);
  row->addWidget(cancel);
  row->addWidget(take_in_);
  connect(scan, &QPushButton::clicked, this, [this] {
    emit scanMeant(QString::fromStdString(presenter_.order().file.string()));
    close();
  });
  connect(cancel, &QPushButton::clicked, this, &QWidget::close);
  connect(take_in_, &QPushButton::clicked, &presenter_, &FieldImportPresenter::takeIn);
  return bar;
}

void FieldImportWindow::open(const QString& file, const QString& surface) {
  presenter_.open(file, surface);
  file_->setText(QFileInfo(file).fileName());
  surface_->setText(surface);
  target_->addItems(presenter_.targets());
  target_->setCurrentText(QString::fromStdString(presenter_.order().target));
  constexpr int kSurfaceRow = 3;
  for (auto* part : findChildren<QWidget*>())
    if (part->property("row").toInt() == kSurfaceRow) part->setVisible(presenter_.needsSurface());
  showState();
}

void FieldImportWindow::showState() {
  words_->setObjectName(presenter_.isRefused() ? "fault" : "said");
  words_->style()->unpolish(words_);
  words_->style()->polish(words_);
  words_->setText(presenter_.words());
  take_in_->setEnabled(presenter_.canTakeIn());
}

}  // namespace facenav::ui
