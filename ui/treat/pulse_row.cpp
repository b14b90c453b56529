#include "treat/pulse_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "shell/elided_label.h"

namespace facenav::ui {
namespace {

QString verdictWords(const session::JudgedPulse& pulse) {
  if (pulse.status == casefile::PulseStatus::on_target)
    return PulseRow::tr("pulse %1: on target").arg(pulse.number);
  const QString verdict =
      pulse.status == casefile::PulseStatus::outside ? PulseRow::tr("OUTSIDE") : PulseRow::tr("LOST");
  return PulseRow::tr("%1 PULSE %2 %3: %4")
      .arg(QChar(0x2715))
      .arg(pulse.number)
      .arg(verdict, QString::fromStdString(pulse.reason));
}

}  // namespace

PulseRow::PulseRow(TreatPresenter& treat, SessionSounds& sounds, QWidget* parent)
    : QWidget(parent), treat_(treat), sounds_(sounds) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  pulses_ = new ElidedLabel(this);  // never widens the window, however many pulses there are
  pulses_->setObjectName("session");
  time_ = new QLabel(this);
  time_->setObjectName("session_time");
  time_->setToolTip(tr("time since guidance was started, without pauses"));
  pulse_ = new QPushButton(tr("Pulse given"), this);
  pulse_->setToolTip(tr("counts a TMS pulse and keeps where the coil was (P)"));
  row->addWidget(pulses_, 1);
  row->addWidget(time_);
  row->addWidget(pulse_);
  last_pulse_ = new ElidedLabel(this);
  last_pulse_->setObjectName("last_pulse");
  column->addLayout(row);
  column->addWidget(last_pulse_);
  // Uses pressed, not clicked: a pulse's time is when the key goes down. A button's own shortcut clicks 0.1 s
  // later.
  connect(pulse_, &QPushButton::pressed, this, &PulseRow::take);
}

void PulseRow::take() {
  treat_.countPulse(times_.pressed());
  refresh();
}

void PulseRow::refresh() {
  const QString failure = treat_.logFailure();
  const QString time = treat_.sessionTime();
  const QString words = !failure.isEmpty() ? tr("NOT LOGGED: %1").arg(failure)
                        : time.isEmpty()   ? tr("no session")
                                           : pulseWords();
  if (words != pulses_->text()) pulses_->set(words);
  time_->setText(time);
  pulse_->setEnabled(treat_.isRunning());
  showLastPulse();
}

/// "pulses 12 of 3000: 10 on target, 1 outside, 1 lost"; omits zero counts.
QString PulseRow::pulseWords() const {
  const auto counts = treat_.pulseCounts();
  QString words = tr("pulses %1").arg(treat_.pulses());
  if (const auto planned = treat_.plannedPulses()) words += tr(" of %1").arg(*planned);
  if (counts.outside + counts.lost == 0) return words;
  words += tr(": %1 on target").arg(counts.on_target);
  if (counts.outside > 0) words += tr(", %1 outside").arg(counts.outside);
  if (counts.lost > 0) words += tr(", %1 lost").arg(counts.lost);
  return words;
}

/// Reports a pulse outside the tolerance at once, until the next pulse.
void PulseRow::showLastPulse() {
  const auto last = treat_.lastPulse();
  const int number = last ? last->number : 0;
  if (number == shown_pulse_) return;
  if (number > shown_pulse_) sounds_.pulse();
  shown_pulse_ = number;
  last_pulse_->set(last ? verdictWords(*last) : QString());
  const bool is_bad = last && last->status != casefile::PulseStatus::on_target;
  if (last_pulse_->property("is_bad").toBool() == is_bad) return;
  last_pulse_->setProperty("is_bad", is_bad);
  last_pulse_->style()->unpolish(last_pulse_);
  last_pulse_->style()->polish(last_pulse_);
}

}  // namespace facenav::ui
