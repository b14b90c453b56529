#include "plan/dose_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

namespace facenav::ui {

DosePanel::DosePanel(PlanPresenter& presenter, QWidget* parent) : QFrame(parent), presenter_(presenter) {
  makeFields();
  connect(choose_, &QPushButton::clicked, this, [this] {
    emit choosing();
    const QString file =
        QFileDialog::getOpenFileName(window(), tr("A protocol"), {}, tr("Protocols (*.json)"));
    if (!file.isEmpty()) presenter_.setProtocol(file);
  });
  connect(remove_, &QPushButton::clicked, &presenter_, &PlanPresenter::removeProtocol);
  connect(choose_coil_, &QPushButton::clicked, this, [this] {
    emit choosing();
    const QString file = QFileDialog::getOpenFileName(window(), tr("A coil"), {}, tr("Coils (*.json)"));
    if (!file.isEmpty()) presenter_.setCoil(file);
  });
  connect(library_coil_, QOverload<int>::of(&QComboBox::activated), this, [this](int item) {
    if (item > 0) presenter_.setCoilNamed(library_coil_->itemText(item));
  });
  connect(apply_, &QPushButton::clicked, this, &DosePanel::apply);
  connect(is_own_, &QCheckBox::clicked, this,
          [this](bool is_own) { is_own ? apply() : presenter_.setDose(std::nullopt); });
  connect(&presenter_, &PlanPresenter::changed, this, &DosePanel::showPlan);
  connect(&presenter_, &PlanPresenter::refused, this, [this](const QString& words) {
    fault_->setText(words);
    fault_->show();
  });
  showPlan();
}

void DosePanel::makeFields() {
  auto* form = new QFormLayout(this);
  const auto label = [&](const QString& words) {
    auto* made = new QLabel(this);
    made->setWordWrap(true);
    made->setMinimumWidth(200);
    form->addRow(words, made);
    return made;
  };
  const auto button = [&](const QString& words, const QString& tip) {
    auto* made = new QPushButton(words, this);
    made->setToolTip(tip);
    return made;
  };
  protocol_ = label(tr("protocol"));
  auto* row = new QHBoxLayout;
  row->addWidget(choose_ = button(tr("Choose a file \u2026"), tr("the case uses this protocol from now on")));
  row->addWidget(remove_ = button(tr("None"), tr("the case has no protocol from now on")));
  form->addRow(row);
  is_own_ = new QCheckBox(tr("the target has its own dose"), this);
  is_own_->setToolTip(tr("numbers for this target alone, in place of the protocol's"));
  form->addRow(is_own_);
  const auto count = [&](const QString& words, int most) {
    auto* made = new QSpinBox(this);
    made->setRange(1, most);
    form->addRow(words, made);
    return made;
  };
  const auto number = [&](const QString& words, double most, const QString& unit, const QString& at_least) {
    auto* made = new QDoubleSpinBox(this);
    made->setRange(0, most);
    made->setDecimals(1);
    made->setSuffix(unit);
    made->setSpecialValueText(at_least);
    form->addRow(words, made);
    return made;
  };
  pulses_ = count(tr("pulses"), 100000);
  trains_ = count(tr("trains"), 100000);
  frequency_ = number(tr("frequency"), 100, tr(" Hz"), tr("single pulses"));
  pause_ = number(tr("pause between trains"), 3600, tr(" s"), {});
  output_ = number(tr("output"), 100, tr(" % of the maximum"), tr("not stated"));
  threshold_ = number(tr("of the threshold"), 200, tr(" %"), tr("not stated"));
  duration_ = label(tr("takes"));
  form->addRow(
      apply_ = button(tr("Apply to the target"), tr("sessions at this target count against these numbers")));
  fault_ = new QLabel(this);
  fault_->setObjectName("fault");
  fault_->setWordWrap(true);
  form->addRow(fault_);
  coil_ = label(tr("coil"));
  library_coil_ = new QComboBox(this);
  library_coil_->setAccessibleName(tr("coil of the library"));
  library_coil_->setToolTip(tr("a coil of the library ('facenav coil add'), by its name"));
  form->addRow(library_coil_);
  form->addRow(choose_coil_ = button(tr("Choose a coil \u2026"),
                                     tr("coil.json; its contact outline rests on the head from now on")));
}

void DosePanel::showPlan() {
  fault_->hide();
  protocol_->setText(presenter_.protocolWords());
  coil_->setText(presenter_.coilWords());
  library_coil_->clear();
  const QStringList coils = presenter_.libraryCoils();
  library_coil_->addItem(coils.isEmpty() ? tr("the library holds no coil") : tr("choose from the library"));
  library_coil_->addItems(coils);
  library_coil_->setEnabled(!coils.isEmpty());
  const auto* active = presenter_.active();
  const bool may_change = active && !active->is_locked;
  for (QWidget* field :
       {static_cast<QWidget*>(is_own_), static_cast<QWidget*>(pulses_), static_cast<QWidget*>(trains_),
        static_cast<QWidget*>(frequency_), static_cast<QWidget*>(pause_), static_cast<QWidget*>(output_),
        static_cast<QWidget*>(threshold_), static_cast<QWidget*>(apply_)})
    field->setEnabled(may_change);
  is_own_->setChecked(active && active->dose);
  const auto dose = presenter_.doseInForce();
  duration_->setText(presenter_.durationWords());
  if (!dose) return;
  pulses_->setValue(dose->pulses);
  trains_->setValue(dose->trains);
  frequency_->setValue(dose->frequency_hz);
  pause_->setValue(dose->pause_s);
  output_->setValue(dose->output_pct.value_or(0));
  threshold_->setValue(dose->threshold_pct.value_or(0));
}

void DosePanel::apply() {
  guidance::Dose dose;
  dose.pulses = pulses_->value();
  dose.trains = trains_->value();
  dose.frequency_hz = frequency_->value();
  dose.pause_s = pause_->value();
  if (output_->value() > 0) dose.output_pct = output_->value();
  if (threshold_->value() > 0) dose.threshold_pct = threshold_->value();
  presenter_.setDose(dose);
}

}  // namespace facenav::ui
