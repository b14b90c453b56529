#include "plan/handle_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "shell/appearance.h"
#include "shell/narrow_label.h"

namespace facenav::ui {

HandlePanel::HandlePanel(PlanPresenter& presenter, QWidget* parent) : QFrame(parent), presenter_(presenter) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  angle_ = field(tr("handle, degrees"),
                 tr("handle angle, -180 to 180 degrees: 0 points straight back, + turns its front to the "
                    "midline (Return)"),
                 &PlanPresenter::setHandle);
  gap_ = field(tr("gap, mm"), tr("between coil and skin, for hair: 0 to 20 mm (Return)"),
               &PlanPresenter::setGap);
  left_ = new QPushButton(tr("\u21ba 5\u00b0"), this);
  right_ = new QPushButton(tr("\u21bb 5\u00b0"), this);
  left_->setToolTip(
      tr("turn the handle anticlockwise, seen from above the coil (Ctrl+left arrow while a view has the "
         "focus)"));
  right_->setToolTip(
      tr("turn the handle clockwise, seen from above the coil (Ctrl+right arrow while a view has the "
         "focus)"));
  for (auto* button : {left_, right_}) button->setObjectName("tool");
  addRow(*grid, 0, tr("handle \u00b0"), angle_);
  grid->addWidget(left_, 0, 2);
  grid->addWidget(right_, 0, 3);
  addRow(*grid, 2, tr("gap mm"), gap_);
  contact_ = new QLabel(this);
  contact_->setObjectName("muted");
  contact_->setToolTip(tr(
      "handle: 0\u00b0 points straight back, + turns its front to the midline; over forehead and occiput it "
      "is measured from superior; below: how the coil's plate stands on the head"));
  makeNarrow(*contact_);
  whenTextScales(this, [this] { keepLines(*contact_); });
  grid->addWidget(contact_, 4, 0, 1, 4);
  grid->setColumnStretch(1, 1);
  connect(left_, &QPushButton::clicked, this, [this] { presenter_.turnActive(-5); });
  connect(right_, &QPushButton::clicked, this, [this] { presenter_.turnActive(5); });
  connect(&presenter_, &PlanPresenter::changed, this, &HandlePanel::showPlan);
  showPlan();
}

HandlePanel::Field HandlePanel::field(const QString& name, const QString& tip,
                                      QString (PlanPresenter::*set)(const QString&)) {
  const Field made{new QLineEdit(this), new QLabel(this)};
  made.line->setAccessibleName(name);
  made.line->setToolTip(tip);
  made.fault->setObjectName("fault");
  makeNarrow(*made.fault);
  made.fault->hide();
  connect(made.line, &QLineEdit::textEdited, made.fault, &QLabel::hide);
  connect(made.line, &QLineEdit::editingFinished, this, [this, made, set] {
    if (!made.line->isModified()) return;
    made.line->setModified(false);
    const QString why = (presenter_.*set)(made.line->text());
    showFigures();  // after a refusal, too: the field shows the valid value again
    made.fault->setText(why);
    made.fault->setVisible(!why.isEmpty());
  });
  return made;
}

void HandlePanel::addRow(QGridLayout& grid, int row, const QString& words, const Field& field) {
  auto* label = new QLabel(words, this);
  label->setObjectName("muted");
  grid.addWidget(label, row, 0);
  grid.addWidget(field.line, row, 1);
  grid.addWidget(field.fault, row + 1, 0, 1, 4);
}

void HandlePanel::showFigures() {
  angle_.line->setText(presenter_.handleFigure());
  gap_.line->setText(presenter_.gapFigure());
}

void HandlePanel::showPlan() {
  showFigures();
  const auto* active = presenter_.active();
  const bool may_change = active && !active->is_locked;
  for (const auto& field : {angle_, gap_}) {
    field.line->setEnabled(may_change);
    field.fault->hide();
  }
  for (auto* button : {left_, right_}) button->setEnabled(may_change);
  contact_->setText(active ? presenter_.handleWords(*active) + "\n" + presenter_.contactWords(*active)
                           : QString());
  keepLines(*contact_);
}

void HandlePanel::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  layout()->activate();  // the label's width is the new one
  keepLines(*contact_);
}

}  // namespace facenav::ui
