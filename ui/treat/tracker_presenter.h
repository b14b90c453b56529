#pragma once
// TrackerPresenter: another tracker whose head and coil a session without cameras uses, by OpenIGTLink
// (treat/served_tracker.h): its address, the names of the poses, the alignment of the tool on the head, and
// what it sends now. The alignment is a file, or points that are touched on the head. Remembered.

#include <QObject>
#include <QStringList>
#include <map>
#include <memory>

#include "facenav/links/igtl_client.h"
#include "facenav/treat/tracker_alignment.h"
#include "facenav/treat/treat_recording.h"
#include "shell/case_model.h"

namespace facenav::ui {

class TrackerPresenter : public QObject {
  Q_OBJECT

 public:
  explicit TrackerPresenter(CaseModel& model, QObject* parent = nullptr);

  /// The choice: words "igtl://HOST[:PORT]/NAME" of the coil, names of head and second coil, alignment file.
  const steps::OtherTracker& tracker() const { return tracker_; }
  void choose(const steps::OtherTracker& tracker);
  /// Connects to the tracker that is chosen. Returns false, after refused(), if the choice is not whole.
  bool open();
  void close();
  bool isOpen() const { return watch_ != nullptr; }
  bool hasAlignment() const { return !tracker_.alignment.empty(); }
  /// "another tracker, Coil1ToTracker at 127.0.0.1".
  QString nameWords() const;
  /// What the tracker sends now: "head and coil are seen", "not connected".
  QString words() const;
  bool isConnected() const { return watch_ && watch_->isConnected(); }
  /// True if head and coil are seen.
  bool isWell() const;

  // Points touched on the head.
  /// Names of the case's landmarks, which can be touched.
  QStringList landmarks() const;
  bool isTouched(const QString& landmark) const { return touched_.count(landmark.toStdString()) > 0; }
  /// Keeps where the pointer's tip is now in the head tool's frame. `pointer`: name of its pose, whose origin
  /// is the tip. Refused if head or pointer is not seen.
  void touch(const QString& landmark, const QString& pointer);
  /// Keeps the touched points in the case as the alignment file, and chooses it. `error_mm`: root mean square
  /// error of a touched point. Refused if they do not make an alignment.
  void alignByPoints(double error_mm);

 signals:
  void changed();
  /// The tracker is used from now on, or no longer.
  void opened();
  void closed();
  void alignmentChanged();
  void refused(const QString& words);

 private:
  CaseModel& model_;
  steps::OtherTracker tracker_;
  std::unique_ptr<links::IgtlClient> watch_;  // null: not in use
  std::map<std::string, steps::TouchedPoint> touched_;
};

}  // namespace facenav::ui
