// The planned field in words: numbers, model and region.

#include <algorithm>
#include <cmath>
#include <vector>

#include "plan/field_presenter.h"

namespace facenav::ui {
namespace {

/// The largest parts of a region, in a line of their own: "   Precentral_L 4.1, Postcentral_L 2.0".
QString labelWords(const steps::FieldRegion& region) {
  constexpr std::size_t kMost = 3;
  constexpr double kLeast_ml = 0.05;  // shown as 0.1
  std::vector<std::pair<std::string, double>> labels(region.by_label.begin(), region.by_label.end());
  std::sort(labels.begin(), labels.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  QStringList words;
  for (std::size_t i = 0; i < std::min(kMost, labels.size()); ++i)
    if (labels[i].second >= kLeast_ml)
      words << QString("%1 %2").arg(QString::fromStdString(labels[i].first)).arg(labels[i].second, 0, 'f', 1);
  return words.isEmpty() ? QString() : "\n   " + words.join(", ");
}

}  // namespace

QString doseWords(const steps::ThresholdDose& dose) {
  const QString words = FieldPresenter::tr(
                            "dose by field: %1 % of the output gives this target the field that "
                            "%2 had at its threshold of %3 %")
                            .arg(std::lround(dose.output_pct))
                            .arg(QString::fromStdString(dose.hotspot))
                            .arg(std::lround(dose.threshold_pct));
  return dose.output_pct > 100 ? words + FieldPresenter::tr(": more than the stimulator has") : words;
}

QString strengthFigure(double strength) {
  return QString::number(strength, 'f', strength >= 10 ? 0 : strength >= 1 ? 1 : 2);
}

QString modelWords(steps::FieldTier tier) {
  const QString models[] = {FieldPresenter::tr("a local sphere"), FieldPresenter::tr("three shells"),
                            FieldPresenter::tr("four shells with the fluid"),
                            FieldPresenter::tr("imported field")};
  return models[int(tier)];
}

QString differenceWords(const steps::PoseComparison& compared) {
  const long change_pct = std::lround(100 * compared.change());
  return FieldPresenter::tr("%1 % at the target, maximum %2 mm away, correlation %3")
      .arg((change_pct < 0 ? QString() : QString("+")) + QString::number(change_pct))
      .arg(std::lround(compared.peak_shift_mm))
      .arg(compared.correlation, 0, 'f', 2);
}

QString FieldPresenter::reachWords() const {
  if (!shown_ || !reach_ || !reach_->regions || !head_) return {};
  const QString surface = head_->surfaces().has_sulci ? tr("cortex") : tr("the brain's hull");
  QStringList lines;
  for (const auto& region : *reach_->regions)
    lines << tr("above %1 %: %2 mm\u00b2 of %3, %4 ml of the brain")
                     .arg(std::lround(100 * region.share))
                     .arg(std::lround(region.area_mm2))
                     .arg(surface)
                     .arg(region.volume_ml, 0, 'f', 1) +
                 labelWords(region);
  return lines.join('\n');
}

QString FieldPresenter::againstWords() const {
  if (!shown_ || !reach_ || !reach_->against || !wanted_ || !wanted_->against) return {};
  return tr("against '%1': %2")
      .arg(QString::fromStdString(wanted_->against->name), differenceWords(*reach_->against));
}

/// Says that the case's shells are older than its masks, and what is done about it.
QString FieldPresenter::oldModelWords() const {
  if (!head_ || !head_->isOutdated()) return {};
  if (!build_failure_.isEmpty())
    return tr("; the three shells are older than the masks and could not be built again: %1")
        .arg(build_failure_);
  return queue_ ? tr("; the three shells are older than the masks and are being built again")
                : tr("; the three shells are older than the masks");
}

QString FieldPresenter::words() const {
  if (!is_on_ || !model_.isOpen()) return {};
  if (!plan_.active()) return tr("no target chosen, so there is no field");
  if (!failure_.isEmpty()) return failure_;
  if (!shown_) return tr("computing the electric field \u2026");
  const QString along =
      std::isnan(shown_->along_normal) ? tr("not known") : strengthFigure(shown_->along_normal);
  const QString strengths =
      tr("E at target %1 V/m, along the normal %2; maximum %3 V/m, %4 mm from the target")
          .arg(strengthFigure(shown_->at_target), along, strengthFigure(shown_->peak))
          .arg(std::lround(shown_->peak_distance_mm));
  const QString dose = shown_->dose ? "\n" + doseWords(*shown_->dose) : QString();
  if (wanted_->imported) return strengths + importedWords();
  return strengths +
         tr("; at %1 A/us; tier %2: %3, usual error %4 %")
             .arg(shown_->rate_A_per_us, 0, 'g', 4)
             .arg(int(shown_->tier))
             .arg(modelWords(shown_->tier))
             .arg(std::lround(100 * shown_->usual_error)) +
         oldModelWords() +
         (fluid_.failure().isEmpty() ? QString()
                                     : tr("; no model with the fluid: %1").arg(fluid_.failure())) +
         dose;
}

/// What the other program stated of its own field, beside what is shown of it.
QString FieldPresenter::importedWords() const {
  const auto& field = *wanted_->imported;
  return tr("; at %1 A/us; imported field (tier 3): its own maximum %2 V/m and 99.9th percentile %3 V/m at "
            "%4 A/us")
      .arg(shown_->rate_A_per_us, 0, 'g', 4)
      .arg(strengthFigure(field.peak), strengthFigure(field.percentile_99_9))
      .arg(field.rate_A_per_us, 0, 'g', 4);
}

QString FieldPresenter::barWords() const {
  return shown_ ? tr("|E|, tier %1").arg(int(shown_->tier)) : QString();
}

}  // namespace facenav::ui
