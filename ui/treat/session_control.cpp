// The running session of TreatPresenter: pulses, answers, pauses, notes, and its end.

#include <QCoreApplication>
#include <QSettings>
#include <QTime>
#include <utility>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/error.h"
#include "shell/shown_words.h"
#include "treat/session_end.h"
#include "treat/treat_presenter.h"

namespace facenav::ui {
namespace {

/// Outputs in a text with blanks or commas between them, each once.
QStringList outputsIn(QString words) {
  QStringList outputs = words.replace(',', ' ').simplified().split(' ', Qt::SkipEmptyParts);
  outputs.removeDuplicates();
  return outputs;
}

}  // namespace

void TreatPresenter::listen() {
  if (pulse_source_.isEmpty() || !isRunning()) return;
  if (const auto fault = treatment_->tryToListen(pulse_source_.toStdString()))
    emit refused(tr("no pulses from outside: %1").arg(shownWords(*fault)));
}

bool TreatPresenter::setPulseSource(const QString& words) {
  try {
    if (!words.trimmed().isEmpty()) links::openPulseSource(words.trimmed().toStdString());
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return false;
  }
  pulse_source_ = words.trimmed();
  QSettings().setValue(kPulseSource, pulse_source_);
  if (isRunning()) treatment_->stopListening();
  listen();
  emit changed();
  return true;
}

void TreatPresenter::chooseSecondCoil(const QString& name) {
  second_.chooseCoil(name);
  emit changed();
}

void TreatPresenter::choosePulseCoil(const QString& coil) {
  second_.choosePulses(coil);
  emit changed();
}

void TreatPresenter::chooseSecondTarget(const QString& name) {
  second_.chooseTarget(name);
  try {
    if (isRunning() && !treatment_->secondCoilName().empty()) {
      if (name.isEmpty())
        treatment_->chooseSecondTarget(std::nullopt, {});
      else
        treatment_->chooseSecondTargetNamed(name.toStdString());
    }
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
  emit changed();
}

QStringList TreatPresenter::targetNames() const {
  QStringList names;
  if (model_.isOpen())
    for (const auto& target : model_.current().plan.targets) names << QString::fromStdString(target.name);
  return names;
}

QString TreatPresenter::obeyOrders() {
  const steps::OrderReceiver nobody{[](const auto&) { return std::string("no session runs"); }};
  const auto* store = model_.isOpen() ? &model_.current().store : nullptr;
  QString newest;
  try {
    auto& orders = offers_.orders();
    for (const auto& news :
         isRunning() && store ? orders.obey(*treatment_, *store) : orders.obey(nobody, store))
      newest = shownWords(news.words);
  } catch (const Error& error) {
    newest = shownWords(error);
  }
  if (newest.isEmpty()) return newest;
  offers_.tellNews();
  emit changed();  // a command may have paused the session
  return newest;
}

bool TreatPresenter::sendTo(const QString& words, bool accepts) {
  bool is_opened = true;
  const QStringList wanted = outputsIn(words), open = sendsTo();
  for (const auto& each : open)
    if (!wanted.contains(each)) outputs_->close(each.toStdString());
  try {
    for (const auto& each : wanted)
      if (!open.contains(each))
        outputs_->open(each.toStdString(), offers_.orders().incoming(accepts, accepts));
  } catch (const Error& error) {
    emit refused(shownWords(error));
    is_opened = false;
  }
  emit changed();
  return is_opened;
}

QStringList TreatPresenter::sendsTo() const {
  QStringList names;
  for (const auto& each : outputs_->names()) names << QString::fromStdString(each);
  return names;
}

QString TreatPresenter::otherOutputs() const { return QSettings().value(kOtherOutputs).toString(); }

bool TreatPresenter::setOtherOutputs(const QString& words) {
  try {
    for (const auto& each : outputsIn(words)) links::requireLiveOutput(each.toStdString());
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return false;
  }
  QSettings().setValue(kOtherOutputs, words.trimmed());
  return true;
}

QStringList TreatPresenter::receivers() const {
  QStringList lines;
  for (const auto& each : outputs_->receivers()) lines << shownWords(each);
  return lines;
}

void TreatPresenter::setIntensity(std::optional<double> intensity_pct) {
  intensity_pct_ = intensity_pct;
  if (treatment_) treatment_->setIntensity(intensity_pct);
  emit changed();
}

bool TreatPresenter::answerPulse(double mep_uv) {
  return isRunning() && treatment_->log().answerPulse(mep_uv);
}

bool TreatPresenter::answerPulse(bool has_twitched) {
  return isRunning() && treatment_->log().answerPulse(has_twitched);
}

bool TreatPresenter::takeBackAnswer() { return isRunning() && treatment_->log().takeBackAnswer(); }

std::optional<session::AddedPulse> TreatPresenter::openPulse() const {
  return isRunning() ? treatment_->log().openPulse() : std::nullopt;
}

int TreatPresenter::newestPulse() const { return treatment_ ? treatment_->log().newestPulse() : 0; }

void TreatPresenter::pause(const QString& reason) {
  if (isRunning()) treatment_->pause(reason.trimmed().toStdString());
  emit changed();
}

void TreatPresenter::resume() {
  if (isRunning()) treatment_->resume();
  emit changed();
}

void TreatPresenter::stopGuiding() { pause(QStringLiteral("guidance stopped")); }

QString TreatPresenter::pauseWords() const {
  if (!isPaused()) return {};
  // An offered reason is kept in English.
  const QString reason =
      QCoreApplication::translate("facenav::ui::SessionPanel", treatment_->log().pauses().reason().c_str());
  return reason.isEmpty() ? tr("PAUSED") : tr("PAUSED: %1").arg(reason);
}

double TreatPresenter::pauseLength_s() const {
  return isPaused() ? treatment_->log().pauses().length_s() : 0.0;
}

void TreatPresenter::checkRegistration() {
  if (isRunning()) treatment_->checkRegistration();
}

void TreatPresenter::judgeTip(steps::TipVerdict verdict, const guidance::TipReading& reading) {
  if (!isRunning()) return;
  treatment_->judgeTip(verdict, reading);
  is_judged_wrong_ |= verdict == steps::TipVerdict::wrong;
  emit changed();
}

bool TreatPresenter::note(const QString& event, const QString& detail) {
  if (last_session_.empty()) {
    emit refused(tr("there is no session yet: start guidance first"));
    return false;
  }
  try {
    const auto words = report::noteWords(detail.toStdString(), event.toStdString());
    if (treatment_) {
      treatment_->log().addEvent(event.toStdString(), words);
      return true;
    }
    casefile::addNote(last_session_, event.toStdString(), words);
    reportBeside(retirement_, model_.current().store.folder(), last_session_);
    return true;
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return false;
  }
}

void TreatPresenter::countPulse(Timestamp at) {
  if (isRunning()) treatment_->pressPulse(at);
}

QString TreatPresenter::sessionTime() const {
  if (!treatment_) return {};
  return QTime(0, 0).addMSecs(int(1e3 * treatment_->log().treated_s())).toString("hh:mm:ss");
}

QString TreatPresenter::summary() const {
  if (!treatment_) return {};
  const auto counts = pulseCounts();
  QString words = tr("%1, %2 pulses").arg(sessionTime()).arg(pulses());
  if (const auto planned = plannedPulses()) words += tr(" of %1").arg(*planned);
  return words + tr(": %1 on target, %2 outside, %3 with face or coil lost")
                     .arg(counts.on_target)
                     .arg(counts.outside)
                     .arg(counts.lost);
}

void TreatPresenter::askEnd() {
  if (!treatment_ || is_ending_) return;
  is_ending_ = true;
  stopped_for_end_ = isGuiding();
  if (stopped_for_end_) treatment_->pause("the session is being ended");
  emit changed();
}

void TreatPresenter::cancelEnd() {
  if (!is_ending_) return;
  is_ending_ = false;
  if (std::exchange(stopped_for_end_, false)) return resume();
  emit changed();
}

void TreatPresenter::end(const QString& pain_after, const QString& adverse) {
  if (!treatment_) return;
  if (!pain_after.isEmpty()) note(report::session_events::kPainAfter, pain_after);
  if (!adverse.trimmed().isEmpty()) note(report::session_events::kAdverse, adverse);
  const QString name = QString::fromStdString(last_session_.filename().string());
  endSession({}, [this, name] {
    QMetaObject::invokeMethod(
        this, [this, name] { emit sessionEnded(name); }, Qt::QueuedConnection);
  });
  emit changed();
}

void TreatPresenter::stop(const std::string& why) {
  if (treatment_) endSession(why);
  emit changed();
}

void TreatPresenter::endSession(const std::string& why, std::function<void()> then) {
  is_ending_ = stopped_for_end_ = false;
  endBeside(retirement_, std::exchange(treatment_, nullptr), why, std::move(then));
}

}  // namespace facenav::ui
