#include "treat/motor_presenter.h"

#include "facenav/core/error.h"

namespace facenav::ui {

MotorPresenter::MotorPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent)
    : QObject(parent), treat_(treat), model_(model) {
  connect(&model_, &CaseModel::opened, this, [this] {
    search_.reset();
    sites_.clear();
    emit changed();
  });
  connect(&treat_, &TreatPresenter::changed, this, [this] {
    const auto* target = treat_.target();  // another target was chosen, which ends the hunt
    if (isHunting() && (!target || target->name != sites_[site_].name)) sites_.clear();
    emit changed();
  });
}

/// Adds one answer to the search, if one runs.
template <class Keep>
void MotorPresenter::take(Keep keep) {
  try {
    if (search_ && !search_->state().isDone()) {
      const auto intensity = treat_.intensity();
      if (!intensity) throw Error("the intensity is not known", {}, "type the output that was set");
      keep(*intensity);
      if (search_->state().isDone())
        treat_.note(report::session_events::kThreshold, QString::fromStdString(search_->inWords()));
      showIntensity();
    }
  } catch (const Error& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
  emit changed();
}

void MotorPresenter::answer(bool has_response) {
  if (!treat_.answerPulse(has_response)) return emit refused(tr("there is no pulse to answer for yet"));
  take([&](double intensity_pct) { search_->answer(intensity_pct, has_response); });
}

void MotorPresenter::answerWithMep(double mep_uv) {
  if (!treat_.answerPulse(mep_uv))
    return emit refused(tr("not taken: there is no pulse yet, or %1 uV is no MEP").arg(mep_uv));
  take([&](double intensity_pct) { search_->answerWithMep(intensity_pct, mep_uv); });
}

void MotorPresenter::showIntensity() {
  if (search_ && search_->state().next_pct) treat_.setIntensity(search_->state().next_pct);
}

void MotorPresenter::search(stimulation::ThresholdMethod method, const QString& muscle) {
  if (!model_.isOpen()) return;
  try {
    search_ = std::make_unique<steps::MotorThreshold>(
        steps::ThresholdRequest{model_.current().store.folder(), method, muscle.trimmed().toStdString()});
    showIntensity();
  } catch (const Error& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
  emit changed();
}

void MotorPresenter::endSearch() {
  search_.reset();
  emit changed();
}

void MotorPresenter::takeBack() {
  if (!search_) return;
  try {
    search_->takeBack();
    showIntensity();
  } catch (const Error& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
  emit changed();
}

QString MotorPresenter::thresholdWords() const {
  if (!search_) return tr("no search runs");
  const auto& state = search_->state();
  const QString words = QString::fromStdString(search_->inWords());
  if (state.isDone()) return tr("THRESHOLD %1").arg(words);
  return tr("set the output to %1 %, one pulse, then answer\n%2").arg(*state.next_pct, 0, 'f', 0).arg(words);
}

void MotorPresenter::hunt() {
  const auto* seed = treat_.target();
  if (!seed || isHunting()) return;
  try {
    sites_ = steps::huntingSites(*seed, *model_.current().scalp, {});
  } catch (const Error& error) {
    return emit refused(QString::fromUtf8(error.what()));
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
