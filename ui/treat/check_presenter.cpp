#include "treat/check_presenter.h"

#include "facenav/core/settings_in_force.h"

namespace facenav::ui {
namespace {

constexpr double kPatience_s = 10;  // added to the check's own time; even a busy machine needs only part of
                                    // it

}  // namespace

CheckPresenter::CheckPresenter(TreatPresenter& treat, QObject* parent) : QObject(parent), treat_(treat) {}

void CheckPresenter::begin() {
  if (!treat_.isRunning() || asked_) return;
  number_ = newest_;
  asked_ = Timestamp::now();
  treat_.checkRegistration();
  follow(*treat_.state());
}

void CheckPresenter::follow(const session::NavigationState& state) {
  using Rules = monitoring::RegistrationCheckRules;
  using Verdict = monitoring::DriftFinding::Verdict;
  if (!treat_.isRunning()) {
    asked_.reset();
    newest_ = 0;
    return set({}, Level::idle);
  }
  const auto* finding = state.check.get();
  newest_ = finding ? finding->number : newest_;
  if (asked_ && newest_ != number_) asked_.reset();
  const double limit_s = settingsOf<Rules>().check_s + kPatience_s;
  if (asked_ && Timestamp::now() - *asked_ < limit_s)
    return set(tr("Measuring the face for %1 s: the patient holds still").arg(settingsOf<Rules>().check_s),
               Level::idle);
  if (asked_) return asked_.reset(), set(tr("Registration not checked: no measurement came"), Level::caution);
  const bool has_failed = finding && finding->verdict == Verdict::drifted;
  if (treat_.isCheckDue() && !has_failed)  // a failure is more urgent than the reminder
    return set(tr("CHECK THE REGISTRATION: the last time was over %1 min ago")
                   .arg(settingsOf<Rules>().ask_after_min),
               Level::caution);
  if (!finding) return set(tr("Registration: as aligned, not checked since"), Level::idle);
  if (finding->verdict == Verdict::unknown)
    return set(tr("Registration not checked: too little of the face seen"), Level::caution);
  const QString off =
      tr("%1 mm, %2\u00b0 off").arg(finding->shift_mm, 0, 'f', 1).arg(finding->turn_deg, 0, 'f', 1);
  if (has_failed) return set(tr("REGISTRATION FAILED: %1; align again").arg(off), Level::lost);
  set(tr("Registration passed: %1, %2 measurements").arg(off).arg(finding->measurements), Level::good);
}

void CheckPresenter::set(const QString& words, Level level) {
  if (words == words_ && level == level_) return;
  words_ = words;
  level_ = level;
  emit changed();
}

}  // namespace facenav::ui
