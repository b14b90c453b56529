#include "treat/pulse_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "shell/appearance.h"
#include "shell/elided_label.h"
#include "shell/narrow_label.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr int kLastPulse_px = 30;  // a line of the style sheet's 22 pt

/// The first two reasons, and how many more there are: two lines at most. The tool tip has all.
QString shortReason(const std::string& reason) {
  QStringList parts;
  for (const QString& part : QString::fromStdString(reason).split("; ")) parts << shownWords(part);
  constexpr int kShown = 2;
  const int more = int(parts.size()) - kShown;
  if (more <= 0) return parts.join("; ");
  return parts.mid(0, kShown).join("; ") + PulseRow::tr("; and %1 more").arg(more);
}

QString verdictWords(const session::JudgedPulse& pulse) {
  if (pulse.status == casefile::PulseStatus::on_target)
    return PulseRow::tr("pulse %1: on target").arg(pulse.number);
  const QString verdict =
      pulse.status == casefile::PulseStatus::outside ? PulseRow::tr("OUTSIDE") : PulseRow::tr("LOST");
  return PulseRow::tr("%1 PULSE %2 %3: %4")
      .arg(QChar(0x2715))
      .arg(pulse.number)
      .arg(verdict, shortReason(pulse.reason));
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
  counts_ = new ElidedLabel(this);
  counts_->setObjectName("pulse_counts");
  last_pulse_ = new QLabel(this);
  last_pulse_->setObjectName("last_pulse");
  makeNarrow(*last_pulse_);  // a pulse outside is told whole, in two lines if need be
  column->addLayout(row);
  counts_->hide();
  column->addWidget(counts_);  // a line of its own: beside the time it would be cut
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
  const QString counts = time.isEmpty() ? QString() : countWords();
  if (counts != counts_->text()) counts_->set(counts);
  counts_->setVisible(!counts.isEmpty());  // no room for it while every pulse is on target
  time_->setText(time);
  pulse_->setEnabled(treat_.isRunning());
  showLastPulse();
}

/// "pulses 12/3000".
QString PulseRow::pulseWords() const {
  QString words = tr("pulses %1").arg(treat_.pulses());
  if (const auto planned = treat_.plannedPulses()) words += tr("/%1").arg(*planned);
  return words;
}

/// "10 on target, 1 outside, 1 lost"; omits zero counts, and is empty while all are on target.
QString PulseRow::countWords() const {
  const auto counts = treat_.pulseCounts();
  if (counts.outside + counts.lost == 0) return {};
  QString words = tr("%1 on target").arg(counts.on_target);
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
  last_pulse_->setText(last ? verdictWords(*last) : QString());
  last_pulse_->setToolTip(last ? shownWords(last->reason) : QString());
  const bool is_bad = last && last->status != casefile::PulseStatus::on_target;
  if (last_pulse_->property("is_bad").toBool() != is_bad) {
    last_pulse_->setProperty("is_bad", is_bad);
    last_pulse_->style()->unpolish(last_pulse_);
    last_pulse_->style()->polish(last_pulse_);
  }
  fitLastPulse();
}

/// Gives the last pulse's words the height of their lines.
void PulseRow::fitLastPulse() {
  const int needed_px = last_pulse_->text().isEmpty() ? 0 : last_pulse_->heightForWidth(last_pulse_->width());
  last_pulse_->setMinimumHeight(std::max(sized(kLastPulse_px), needed_px));
}

void PulseRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate();  // the label's width is the new one
  fitLastPulse();
}

}  // namespace facenav::ui
