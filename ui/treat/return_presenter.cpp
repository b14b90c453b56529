#include "treat/return_presenter.h"

#include <QDateTime>

#include "facenav/core/error.h"
#include "facenav/treat/session_return.h"

namespace facenav::ui {
namespace {

constexpr double kMinute_s = 60, kHour_s = 3600;

QString agoInWords(double seconds) {
  if (seconds < kMinute_s) return ReturnPresenter::tr("less than a minute ago");
  if (seconds < kHour_s) return ReturnPresenter::tr("%1 min ago").arg(int(seconds / kMinute_s));
  return ReturnPresenter::tr("%1 h ago").arg(seconds / kHour_s, 0, 'f', 1);
}

/// "14:05" from 20261123T140509Z, in local time; with the day if it is not today. Other names are returned
/// unchanged.
QString beginInWords(const std::string& name) {
  auto begin = QDateTime::fromString(QString::fromStdString(name).left(15), "yyyyMMdd'T'HHmmss");
  if (!begin.isValid()) return QString::fromStdString(name);
  begin.setTimeSpec(Qt::UTC);
  const auto local = begin.toLocalTime();
  const QString time = local.toString("HH:mm");
  return local.date() == QDate::currentDate() ? time
                                              : QLocale(QLocale::English).toString(local, "d MMM, ") + time;
}

}  // namespace

ReturnPresenter::ReturnPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent)
    : QObject(parent), treat_(treat), model_(model) {
  connect(&model_, &CaseModel::opened, this, &ReturnPresenter::look);
  connect(&treat_, &TreatPresenter::changed, this, &ReturnPresenter::follow);
}

void ReturnPresenter::look() {
  offered_.reset();
  planned_.reset();
  if (model_.isOpen() && !treat_.isRunning()) {
    const auto folder = model_.current().store.folder();
    offered_ = steps::interruptedSession(folder);
    try {
      if (offered_) planned_ = steps::plannedPulses(folder, offered_->target);
    } catch (const Error&) {
      // If the protocol cannot be read, the session is offered without its goal.
    }
  }
  emit changed();
}

void ReturnPresenter::follow() {
  const bool is_running = treat_.isRunning();
  if (is_running == was_running_) {
    emit changed();  // cameras may have been opened or closed
    return;
  }
  was_running_ = is_running;
  look();
}

QString ReturnPresenter::words() const {
  if (!offered_) return {};
  QString kept;
  if (planned_)
    kept = tr("%1 of %2 pulses are kept").arg(offered_->pulses()).arg(*planned_);
  else
    kept = offered_->pulses() == 1 ? tr("1 pulse is kept") : tr("%1 pulses are kept").arg(offered_->pulses());
  if (!offered_->target.empty()) kept += tr(", target %1").arg(QString::fromStdString(offered_->target));
  const QString how = offered_->has_ended
                          ? tr("The session of %1 was ended %2 before its plan was given: %3.")
                          : tr("The session of %1 was cut off %2: %3.");
  return how.arg(beginInWords(offered_->name), agoInWords(offered_->idle_s), kept);
}

QString ReturnPresenter::missing() const {
  if (!treat_.mayTreat()) return tr("the case is not signed off");
  if (!treat_.hasRecording()) return tr("open the cameras first (step 1)");
  return {};
}

void ReturnPresenter::goOn() {
  if (offered_ && missing().isEmpty()) treat_.goOn(*offered_);
}

void ReturnPresenter::beginNew() {
  offered_.reset();
  emit changed();
}

}  // namespace facenav::ui
