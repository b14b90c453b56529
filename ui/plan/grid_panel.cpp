#include "plan/grid_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

namespace facenav::ui {

GridPanel::GridPanel(PlanPresenter& presenter, QWidget* parent) : QFrame(parent), presenter_(presenter) {
  auto* form = new QFormLayout(this);
  const auto count = [&](const QString& words, int value) {
    auto* made = new QSpinBox(this);
    made->setRange(1, 15);
    made->setValue(value);
    made->setAccessibleName(words);
    form->addRow(words, made);
    return made;
  };
  rows_ = count(tr("rows"), 5);
  columns_ = count(tr("columns"), 5);
  spacing_ = new QDoubleSpinBox(this);
  spacing_->setRange(1, 30);
  spacing_->setSingleStep(0.5);
  spacing_->setDecimals(1);
  spacing_->setValue(7.5);
  spacing_->setSuffix(tr(" mm"));
  spacing_->setAccessibleName(tr("spacing"));
  form->addRow(tr("spacing"), spacing_);
  on_ = new QComboBox(this);
  on_->addItems({tr("on the scalp"), tr("on the cortex")});
  form->addRow(tr("measured"), on_);
  make_ = new QPushButton(tr("Make the grid"), this);
  make_->setToolTip(tr("targets round the active one, handles along the curvature; edited ones stay"));
  remove_ = new QPushButton(tr("Remove the grid"), this);
  remove_->setToolTip(tr("removes its targets; those that were edited by hand stay"));
  form->addRow(make_);
  form->addRow(remove_);
  fault_ = new QLabel(this);
  fault_->setObjectName("fault");
  fault_->setWordWrap(true);
  fault_->hide();
  form->addRow(fault_);
  connect(make_, &QPushButton::clicked, this, &GridPanel::make);
  connect(remove_, &QPushButton::clicked, this, [this] { set(std::nullopt); });
  connect(&presenter_, &PlanPresenter::refused, this, &GridPanel::showFault);
  connect(&presenter_, &PlanPresenter::changed, this, &GridPanel::showActive);
  showActive();
}

/// Sets or removes the grid. A refusal stays in sight; else the panel is done.
void GridPanel::set(const std::optional<guidance::GridSpec>& grid) {
  showFault({});
  presenter_.setGrid(grid);
  if (fault_->text().isEmpty()) emit done();
}

void GridPanel::showFault(const QString& words) {
  fault_->setText(words);
  fault_->setVisible(!words.isEmpty());
}

/// Makes the grid, which takes a few seconds if it is large; button and pointer say so.
void GridPanel::make() {
  const QString words = make_->text();
  make_->setText(tr("Making the grid \u2026"));
  make_->repaint();
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  set(guidance::GridSpec{rows_->value(), columns_->value(), spacing_->value(),
                         on_->currentIndex() == 1 ? guidance::GridOn::cortex : guidance::GridOn::scalp});
  QGuiApplication::restoreOverrideCursor();
  make_->setText(words);
}

void GridPanel::showActive() {
  showFault({});
  const auto* target = presenter_.active();
  make_->setEnabled(target);
  remove_->setEnabled(target && target->grid);
  if (!target || !target->grid) return;
  rows_->setValue(target->grid->rows);
  columns_->setValue(target->grid->columns);
  spacing_->setValue(target->grid->spacing_mm);
  on_->setCurrentIndex(target->grid->on == guidance::GridOn::cortex ? 1 : 0);
}

}  // namespace facenav::ui
