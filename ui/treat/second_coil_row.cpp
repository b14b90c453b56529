#include "treat/second_coil_row.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

#include "shell/users_words.h"

namespace facenav::ui {
namespace {

/// Fills a box with a first line that means none.
void fill(QComboBox& box, const QString& none, const QStringList& names, const QString& chosen) {
  box.clear();
  box.addItem(none);
  box.addItems(names);
  box.setCurrentIndex(chosen.isEmpty() ? 0 : qMax(0, box.findText(chosen)));
}

QString chosenIn(const QComboBox& box) { return box.currentIndex() > 0 ? box.currentText() : QString(); }

}  // namespace

SecondCoilRow::SecondCoilRow(TreatPresenter& treat, QWidget* parent) : QWidget(parent), treat_(treat) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("second coil"), this));
  const auto addBox = [&](const QString& name, const QString& tip) {
    auto* box = new QComboBox(this);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(7);
    box->setAccessibleName(name);
    box->setToolTip(tip);
    markUsersWords(*box);
    row->addWidget(box, 1);
    return box;
  };
  coil_ =
      addBox(tr("second coil"), tr("a second coil with a marker of its own, followed in the next session"));
  target_ = addBox(tr("the second coil's target"), tr("the second coil's own target"));
  pulses_ = addBox(tr("coil of the pulses"), tr("which of both coils gives the pulses of the next session"));
  connect(coil_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { treat_.chooseSecondCoil(chosenIn(*coil_)); });
  connect(target_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { treat_.chooseSecondTarget(chosenIn(*target_)); });
  connect(pulses_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { treat_.choosePulseCoil(chosenIn(*pulses_)); });
  connect(&treat_, &TreatPresenter::changed, this, &SecondCoilRow::showState);
  showState();
}

void SecondCoilRow::showState() {
  const auto& second = treat_.secondCoil();
  QStringList others = SecondCoilChoice::names();
  others.removeAll(treat_.coilName());
  fill(*coil_, tr("none"), others, second.coil());
  fill(*target_, tr("no target"), treat_.targetNames(), second.target());
  fill(*pulses_, tr("pulses of?"), {treat_.coilName(), second.coil()}, second.pulses());
  const bool has_second = !second.coil().isEmpty();
  coil_->setEnabled(!treat_.isRunning());
  target_->setVisible(has_second);
  pulses_->setVisible(has_second);
  pulses_->setEnabled(!treat_.isRunning());
}

}  // namespace facenav::ui
