#pragma once
// TreatPresenter: cameras (a recording), align, guide: runs the Session and says what to show.

#include <QObject>
#include <memory>

#include "facenav/session/camera_overlay.h"
#include "presenters/case_model.h"
#include "presenters/read_out.h"
#include "presenters/services.h"
#include "presenters/task_runner.h"

namespace facenav::ui {

class TreatPresenter : public QObject {
  Q_OBJECT

 public:
  TreatPresenter(const Services& services, CaseModel& model, TaskRunner& tasks, QObject* parent = nullptr);
  ~TreatPresenter() override;

  /// Step 1: opens and checks a recording folder.
  void openRecording(const QString& folder);
  /// Step 2: aligns from the capture pair; step 3 follows at once when `then_start`.
  void align(bool then_start);
  /// Step 3: plays the recording live.
  void start();
  void stop();
  void chooseTarget(const QString& name);

  bool hasRecording() const { return recording_.has_value(); }
  bool isAligned() const { return outcome_ != nullptr; }
  bool isRunning() const { return session_ != nullptr && !session_->hasEnded(); }
  /// The recording has been played to its end, or a fault stopped it.
  bool hasEnded() const { return session_ != nullptr && session_->hasEnded(); }
  QString recordingWords() const;
  QString alignmentWords() const;
  QString targetName() const { return target_; }
  /// The chosen target, or null.
  const guidance::Target* target() const;

  /// The newest state; everything lost when nothing runs.
  std::shared_ptr<const session::NavigationState> state() const;
  session::CameraOverlay overlay(const session::NavigationState& state) const;

 signals:
  void changed();

 private:
  void startNavigator(std::shared_ptr<session::Navigator> navigator);
  std::optional<session::ChosenTarget> chosen() const;

  const Services& services_;
  CaseModel& model_;
  TaskRunner& tasks_;
  std::optional<capture::Recording> recording_;
  tracking::CoilModel coil_;
  std::shared_ptr<const session::AlignmentOutcome> outcome_;
  std::unique_ptr<session::Session> session_;
  QString target_;
};

}  // namespace facenav::ui
