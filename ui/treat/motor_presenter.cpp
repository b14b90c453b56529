#include "treat/motor_presenter.h"

#include "facenav/core/error.h"
#include "shell/shown_words.h"

namespace facenav::ui {

MotorPresenter::MotorPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent)
    : QObject(parent), treat_(treat), model_(model) {
  connect(&model_, &CaseModel::opened, this, [this] {
    search_.reset();
    sites_.clear();
    answered_ = 0;
    emit changed();
  });
  connect(&treat_, &TreatPresenter::changed, this, [this] {
    if (!treat_.isRunning()) answered_ = before_search_ = 0;  // the next session counts anew
    const auto* target = treat_.target();  // another target was chosen, which ends the hunt
    if (isHunting() && (!target || target->name != sites_[site_].name)) sites_.clear();
    emit changed();
  });
}

/// Adds the pulse's answer to the search, if one runs and the pulse belongs to it.
template <class Keep>
void MotorPresenter::take(const session::AddedPulse& pulse, Keep keep) {
  answered_ = pulse.number;
  was_searched_ = false;
  try {
    if (search_ && !search_->state().isDone() && pulse.number > before_search_) {
      if (!pulse.intensity_pct)
        throw Error("the intensity of pulse " + std::to_string(pulse.number) + " is not known", {},
                    "type the output that is set, before the next pulse");
      keep(*pulse.intensity_pct);
      was_searched_ = true;
      if (search_->state().isDone()) {
        treat_.note(report::session_events::kThreshold, QString::fromStdString(search_->inWords()));
        emit found();
      }
      showIntensity();
    }
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
  emit changed();
}

void MotorPresenter::answer(bool has_response) {
  const auto pulse = treat_.openPulse();
  if (!pulse || !treat_.answerPulse(has_response)) return emit refused(question());
  take(*pulse, [&](double intensity_pct) { search_->answer(intensity_pct, has_response); });
}

void MotorPresenter::answerWithMep(double mep_uv) {
  const auto pulse = treat_.openPulse();
  if (!pulse) return emit refused(question());
  if (!treat_.answerPulse(mep_uv)) return emit refused(tr("not taken: %1 uV is no MEP").arg(mep_uv));
  take(*pulse, [&](double intensity_pct) { search_->answerWithMep(intensity_pct, mep_uv); });
}

QString MotorPresenter::question() const {
  if (!treat_.isRunning()) return tr("the muscle's answers: one a pulse, while guidance runs");
  if (const auto pulse = treat_.openPulse())
    return tr("Pulse %1%2: did the muscle move?")
        .arg(pulse->number)
        .arg(pulse->intensity_pct ? tr(" at %1 %").arg(*pulse->intensity_pct, 0, 'g', 4) : QString());
  if (treat_.newestPulse() == 0) return tr("No pulse to answer for yet: give one first");
  return tr("Pulse %1 is answered: give the next one").arg(treat_.newestPulse());
}

void MotorPresenter::showIntensity() {
  if (search_ && search_->state().next_pct) treat_.setIntensity(search_->state().next_pct);
}

void MotorPresenter::search(stimulation::ThresholdMethod method, const QString& muscle) {
  if (!model_.isOpen()) return;
  try {
    steps::ThresholdRequest request{model_.current().store.folder(), method, muscle.trimmed().toStdString()};
    if (const auto* target = treat_.target()) request.target = *target;
    search_ = std::make_unique<steps::MotorThreshold>(request);
    before_search_ = treat_.newestPulse();
    was_searched_ = false;
    showIntensity();
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
  emit changed();
}

void MotorPresenter::endSearch() {
  search_.reset();
  emit changed();
}

void MotorPresenter::takeBack() {
  const bool is_of_pulse = answered_ > 0;
  if (is_of_pulse) treat_.takeBackAnswer();
  answered_ = 0;
  try {
    // An answer of an earlier run of the search, or the one just taken back.
    if (search_ && (was_searched_ || !is_of_pulse) && search_->state().pulses > 0) {
      search_->takeBack();
      showIntensity();
    }
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
  was_searched_ = false;
  emit changed();
}

QString MotorPresenter::thresholdWords() const {
  if (!search_) return tr("no search runs");
  const auto& state = search_->state();
  const QString words = shownWords(search_->inWords());
  if (state.isDone()) return tr("THRESHOLD %1").arg(words);
  return tr("set the output to %1 %, one pulse, then answer\n%2").arg(*state.next_pct, 0, 'f', 0).arg(words);
}

void MotorPresenter::setDose(const QString& words) {
  dose_ = words;
  emit changed();
}

void MotorPresenter::hunt() {
  const auto* seed = treat_.target();
  if (!seed || isHunting()) return;
  try {
    sites_ = steps::huntingSites(*seed, *model_.current().scalp, {});
  } catch (const Error& error) {
    return emit refused(shownWords(error));
  }
  site_ = 0;
  if (isHunting()) treat_.guideTo(sites_[site_]);
  emit changed();
}

void MotorPresenter::endHunt() {
  sites_.clear();
  treat_.guideTo(std::nullopt);
}

void MotorPresenter::nextSite(int step) {
  if (!isHunting()) return;
  const auto count = int(sites_.size());
  site_ = std::size_t((int(site_) + step + count) % count);
  treat_.guideTo(sites_[site_]);
}

QString MotorPresenter::siteWords() const {
  if (!isHunting()) return {};
  return tr("site %1 of %2: %3")
      .arg(site_ + 1)
      .arg(sites_.size())
      .arg(QString::fromStdString(sites_[site_].name));
}

}  // namespace facenav::ui
