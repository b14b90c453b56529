#include "plan/handle_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

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
  auto* left = new QPushButton(tr("\u21ba 5\u00b0"), this);
  auto* right = new QPushButton(tr("\u21bb 5\u00b0"), this);
  left->setToolTip(tr("turn the handle anticlockwise, seen from above the coil (Q)"));
  right->setToolTip(tr("turn the handle clockwise, seen from above the coil (E)"));
  for (auto* button : {left, right}) button->setObjectName("tool");
  const auto word = [this](const QString& words) {
    auto* made = new QLabel(words, this);
    made->setObjectName("muted");
    return made;
  };
  grid->addWidget(word(tr("handle \u00b0")), 0, 0);
  grid->addWidget(angle_, 0, 1);
  grid->addWidget(left, 0, 2);
  grid->addWidget(right, 0, 3);
  grid->addWidget(word(tr("gap mm")), 1, 0);
  grid->addWidget(gap_, 1, 1);
  grid->setColumnStretch(1, 1);
  connect(left, &QPushButton::clicked, this, [this] { presenter_.turnActive(-5); });
  connect(right, &QPushButton::clicked, this, [this] { presenter_.turnActive(5); });
  connect(&presenter_, &PlanPresenter::changed, this, &HandlePanel::showFigures);
  showFigures();
}

QLineEdit* HandlePanel::field(const QString& name, const QString& tip,
                              void (PlanPresenter::*set)(const QString&)) {
  auto* made = new QLineEdit(this);
  made->setAccessibleName(name);
  made->setToolTip(tip);
  connect(made, &QLineEdit::editingFinished, this, [this, made, set] {
    if (!made->isModified()) return;
    made->setModified(false);
    (presenter_.*set)(made->text());
    showFigures();  // after a refusal, too: the field shows the valid value again
  });
  return made;
}

void HandlePanel::showFigures() {
  angle_->setText(presenter_.handleFigure());
  gap_->setText(presenter_.gapFigure());
  for (auto* field : {angle_, gap_}) field->setEnabled(presenter_.active() != nullptr);
}

}  // namespace facenav::ui
