#include "treat/tracker_presenter.h"

#include <QSettings>

#include "facenav/casefile/landmarks_file.h"
#include "facenav/core/error.h"
#include "facenav/treat/served_tracker.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr const char *kWords = "tracker/coil", *kHead = "tracker/head", *kSecond = "tracker/second_coil";
constexpr const char* kAlignmentFile = "tracker_alignment.json";  // in the case

QString seenWords(const links::IgtlReading& reading, const QString& tool) {
  if (reading.pose) return TrackerPresenter::tr("%1 is seen").arg(tool);
  return reading.fault.empty() ? TrackerPresenter::tr("%1 is not seen").arg(tool)
                               : TrackerPresenter::tr("%1: %2").arg(tool, shownWords(reading.fault));
}

}  // namespace

TrackerPresenter::TrackerPresenter(CaseModel& model, QObject* parent) : QObject(parent), model_(model) {
  const QSettings settings;
  const auto kept = [&](const char* key) { return settings.value(key).toString().toStdString(); };
  tracker_.words = kept(kWords);
  tracker_.head = kept(kHead);
  tracker_.second_coil = kept(kSecond);
  connect(&model_, &CaseModel::opened, this, [this] {  // the alignment is that of one head
    tracker_.alignment.clear();
    touched_.clear();
    emit changed();
  });
}

void TrackerPresenter::choose(const steps::OtherTracker& tracker) {
  const bool is_same = tracker.words == tracker_.words && tracker.head == tracker_.head &&
                       tracker.second_coil == tracker_.second_coil;
  const bool is_aligned_anew = tracker.alignment != tracker_.alignment;
  tracker_ = tracker;
  if (!is_same) close();
  if (is_aligned_anew) emit alignmentChanged();
  QSettings settings;
  settings.setValue(kWords, QString::fromStdString(tracker_.words));
  settings.setValue(kHead, QString::fromStdString(tracker_.head));
  settings.setValue(kSecond, QString::fromStdString(tracker_.second_coil));
  emit changed();
}

bool TrackerPresenter::open() {
  try {
    if (tracker_.head.empty()) throw Error("the head's pose has no name", {}, "type it, as SubjectToTracker");
    steps::makeServedTrackers(tracker_.words, tracker_.head, tracker_.second_coil);  // refuses wrong words
    const auto served = links::servedPoseFrom(tracker_.words);
    watch_ = std::make_unique<links::IgtlClient>(served.host, served.port);
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return false;
  }
  emit opened();
  emit changed();
  return true;
}

void TrackerPresenter::close() {
  if (!watch_) return;
  watch_.reset();
  emit closed();
  emit changed();
}

QString TrackerPresenter::nameWords() const {
  return tr("another tracker, %1").arg(QString::fromStdString(tracker_.words));
}

QString TrackerPresenter::words() const {
  if (!watch_) return tr("not in use");
  if (!watch_->isConnected()) return tr("the tracker does not answer; it is asked again and again");
  const auto readings = watch_->read({tracker_.head, links::servedPoseFrom(tracker_.words).name});
  return seenWords(readings[0], tr("the head")) + "; " + seenWords(readings[1], tr("the coil"));
}

bool TrackerPresenter::isWell() const {
  if (!isConnected()) return false;
  const auto readings = watch_->read({tracker_.head, links::servedPoseFrom(tracker_.words).name});
  return readings[0].pose && readings[1].pose;
}

QStringList TrackerPresenter::landmarks() const {
  QStringList names;
  if (!model_.isOpen()) return names;
  try {
    const auto landmarks = casefile::readLandmarks(model_.current().store.folder());
    for (const auto which : surface::kLandmarks)
      if (landmarks && (*landmarks)[which]) names << QString::fromStdString(toString(which));
  } catch (const Error&) {  // damaged: Plan says so when it is asked for them
  }
  return names;
}

void TrackerPresenter::touch(const QString& landmark, const QString& pointer) {
  if (!watch_ || !model_.isOpen()) return void(emit refused(tr("use the tracker first")));
  const auto readings = watch_->read({tracker_.head, pointer.trimmed().toStdString()});
  if (!readings[0].pose || !readings[1].pose)
    return void(emit refused(seenWords(readings[readings[0].pose ? 1 : 0],
                                       readings[0].pose ? tr("the pointer") : tr("the head"))));
  const auto which = surface::landmarkFrom(landmark.toStdString());
  const auto landmarks = casefile::readLandmarks(model_.current().store.folder());
  steps::TouchedPoint point;
  point.name = landmark.toStdString();
  point.in_mri = (*landmarks)[which]->point;
  point.in_subject_mm = readings[0].pose->inverse() * readings[1].pose->translation();
  touched_[point.name] = point;
  emit changed();
}

void TrackerPresenter::alignByPoints(double error_mm) {
  if (!model_.isOpen()) return;
  const auto file = model_.current().store.folder() / kAlignmentFile;
  std::vector<steps::TouchedPoint> points;
  for (const auto& [name, point] : touched_) points.push_back(point);
  try {
    steps::writeTouchedPoints(points, error_mm, file);
    tracker_.alignment = file;
    emit alignmentChanged();
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
  emit changed();
}

}  // namespace facenav::ui
