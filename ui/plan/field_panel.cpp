#include "plan/field_panel.h"

#include <QActionEvent>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>

#include "shell/users_words.h"

namespace facenav::ui {

FieldPanel::FieldPanel(FieldPresenter& presenter, QWidget* parent) : QFrame(parent), presenter_(presenter) {
  auto* form = new QFormLayout(this);
  is_on_ = new QCheckBox(tr("Electric field"), this);
  is_on_->setToolTip(tr("the field that the planned coil induces, in colours on the brain, in V/m"));
  form->addRow(is_on_);
  coil_ = new QComboBox(this);
  coil_->setToolTip(tr("whose field it is: a built-in coil, or a file (.ccd .tcd .nii.gz) of SimNIBS"));
  coil_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  markUsersWords(*coil_);
  form->addRow(tr("coil"), coil_);
  rate_ = new QDoubleSpinBox(this);
  rate_->setRange(kLeastRate, mostRate(presenter_.rate().unit));
  rate_->setDecimals(1);
  rate_->setKeyboardTracking(false);
  rate_->setAccessibleName(tr("rate of the current"));
  unit_ = new QComboBox(this);
  unit_->setAccessibleName(tr("unit of the current"));
  unit_->addItems({tr("A/us"), tr("% of the output")});
  for (QWidget* field : {static_cast<QWidget*>(rate_), static_cast<QWidget*>(unit_)})
    field->setToolTip(tr("how fast the coil's current rises; % if the coil's file states its largest rate"));
  auto* row = new QHBoxLayout;
  row->addWidget(rate_, 1);
  row->addWidget(unit_);
  form->addRow(tr("current"), row);
  imported_ = new QCheckBox(tr("imported field (tier 3)"), this);
  imported_->setToolTip(
      tr("the field that another program computed for this pose, in place of the case's own model; only for "
         "the pose for which it was imported"));
  form->addRow(imported_);
  connect(imported_, &QCheckBox::toggled, &presenter_, &FieldPresenter::preferImported);
  fluid_ = new QPushButton(this);
  fluid_->setObjectName("tool");
  form->addRow(fluid_);
  connect(fluid_, &QPushButton::clicked, this, [this] {
    auto& fluid = presenter_.fluid();
    fluid.isBuilding() ? fluid.cancel() : fluid.build();
  });
  connect(&presenter_.fluid(), &FluidPresenter::changed, this, &FieldPanel::showFluid);
  connect(is_on_, &QCheckBox::toggled, &presenter_, &FieldPresenter::setOn);
  connect(coil_, QOverload<int>::of(&QComboBox::activated), this, &FieldPanel::choose);
  const auto setRate = [this] {
    presenter_.setRate({rate_->value(), steps::CurrentRate::Unit(unit_->currentIndex())});
  };
  connect(rate_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, setRate);
  connect(unit_, QOverload<int>::of(&QComboBox::activated), this, setRate);
  reach_ = new QLabel(this);
  reach_->setObjectName("figures_text");
  reach_->setToolTip(tr(
      "what gets at least 50, 75 and 90 % of the maximum: area of the cortex' surface; volume of the brain "
      "mask, grey and white matter together, by AAL label in ml"));
  form->addRow(reach_);
  connect(&presenter_, &FieldPresenter::changed, this, &FieldPanel::showChoices);
  connect(&presenter_, &FieldPresenter::reachChanged, this, &FieldPanel::showReach);
  showChoices();
  showReach();
  showFluid();
}

void FieldPanel::showReach() {
  const QString words = presenter_.reachWords();
  reach_->setText(words.isEmpty() && presenter_.wanted() ? tr("measuring the region \u2026") : words);
  reach_->setVisible(!reach_->text().isEmpty());
  fitMenu();
}

/// An open menu takes the new size of its words.
void FieldPanel::fitMenu() {
  auto* menu = qobject_cast<QMenu*>(parentWidget());
  if (!menu || !menu->isVisible()) return;
  QActionEvent grown(QEvent::ActionChanged, menu->actions().first());
  QApplication::sendEvent(menu, &grown);
}

void FieldPanel::showFluid() {
  const auto& fluid = presenter_.fluid();
  if (fluid_->text() != fluid.words()) {
    fluid_->setText(fluid.words());
    fitMenu();
  }
  fluid_->setEnabled(fluid.isPossible() || fluid.isBuilding());
  fluid_->setToolTip(
      !fluid.failure().isEmpty()
          ? fluid.failure()
          : tr("builds the head's model with the fluid round the brain (tier 2), which changes "
               "the field most; needs 2 GB of memory meanwhile; the case keeps it"));
}

void FieldPanel::choose(int item) {
  const QString chosen = coil_->itemData(item).toString();
  if (!chosen.isEmpty()) return presenter_.setCoil(chosen);
  emit choosing();
  const QString file = QFileDialog::getOpenFileName(window(), tr("A coil's field"), {},
                                                    tr("Coils (*.ccd *.tcd *.nii *.nii.gz)"));
  file.isEmpty() ? showChoices() : presenter_.setCoil(file);
}

void FieldPanel::showChoices() {
  const QSignalBlocker quiet_switch(is_on_), quiet_rate(rate_), quiet_import(imported_);
  is_on_->setChecked(presenter_.isOn());
  imported_->setChecked(presenter_.prefersImported());
  if (imported_->isHidden() == presenter_.hasImported()) {
    imported_->setVisible(presenter_.hasImported());
    fitMenu();
  }
  rate_->setMaximum(mostRate(presenter_.rate().unit));
  rate_->setValue(presenter_.rate().value);
  unit_->setCurrentIndex(int(presenter_.rate().unit));
  coil_->clear();
  const QString words[] = {tr("figure-8, 70 mm"), tr("round, 90 mm")};
  coil_->setMinimumContentsLength(int(words[0].size()) + 1);
  for (std::size_t i = 0; i < efield::builtInCoils().size(); ++i)
    coil_->addItem(words[i], QString::fromStdString(efield::builtInCoils()[i]));
  if (coil_->findData(presenter_.coil()) < 0)
    coil_->addItem(QFileInfo(presenter_.coil()).fileName(), presenter_.coil());
  coil_->setCurrentIndex(coil_->findData(presenter_.coil()));
  coil_->addItem(tr("Choose a file \u2026"));
}

}  // namespace facenav::ui
