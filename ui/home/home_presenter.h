#pragma once
// HomePresenter: treatment by a person at home or a nurse, in three steps: sit and look, hold the coil,
// follow the arrow; then one file to send back. It refuses what it cannot verify, in one sentence. The steps
// are those of home/home_case.h, home_advice.h and treatment.h.

#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>

#include "facenav/home/home_advice.h"
#include "facenav/home/home_case.h"
#include "facenav/treat/treatment.h"
#include "shell/asynchronous_shutdown.h"
#include "shell/services.h"
#include "shell/task_runner.h"
#include "treat/cameras_presenter.h"

namespace facenav::ui {

class HomePresenter : public QObject {
  Q_OBJECT

 public:
  /// Stage of the treatment. opening: the case is read. unusable: the case cannot be used for treatment. sit:
  /// before the face is measured. starting: the face is measured, or the trackers start. guiding, ending,
  /// ended.
  enum class Stage { opening, unusable, sit, starting, guiding, ending, ended };

  HomePresenter(const Services& services, TaskRunner& tasks, QObject* parent = nullptr);
  ~HomePresenter() override;

  void open(const QString& case_folder);
  /// Uses a recording in place of the cameras.
  void play(const QString& recording);
  CamerasPresenter& cameras() { return cameras_; }
  bool hasPictures() const { return recording_.has_value() || cameras_.isLive(); }

  Stage stage() const { return stage_; }
  /// Why the last step was refused, in one sentence; empty if it was not.
  QString refusal() const { return refusal_; }
  /// True while the person is asked whether to finish: the next act() does, and some seconds later, or at
  /// goOn(), the session simply goes on.
  bool asksToFinish() const;
  void goOn();
  /// Text of the big button: "START", "TAKE THE PICTURE", "FINISH", ..; empty if it does nothing.
  QString actionWords() const;
  /// What to do while no session runs, in one sentence.
  QString words() const;
  /// Does what the big button offers.
  void act();
  /// Returns the next step of a running session.
  steps::HomeAdvice advice();
  std::shared_ptr<const session::NavigationState> state() const;
  /// Picture to show while no camera gives one: the recording's, or the one that the face is measured in.
  /// Null if there is none.
  std::shared_ptr<const cameras::StereoFrame> stillPicture() const;

  void countPulse(Timestamp at = Timestamp::now());
  session::PulseCounts pulseCounts() const;
  std::optional<int> plannedPulses() const;
  /// Reminder about the coil, such as an old calibration; empty if there is none.
  QString reminder() const;

  /// Name of the file to send back: "facenav_20261123T140509Z.zip".
  QString sendBackName() const;
  /// Writes the file to send back. Returns false, with refusal(), if that fails.
  bool save(const QString& file);
  /// Writes the file to send back into each of the folders. Returns those that have it; empty, with
  /// refusal(), if none could be written.
  QStringList saveIn(const QStringList& folders);
  /// Path of the saved file, the first one; empty before.
  QString savedAs() const { return saved_as_; }

 signals:
  void changed();
  /// The user must choose a name for the file.
  void saveWanted();

 private:
  void set(Stage stage, const QString& refusal = {});
  void align();
  void startTrackers(std::shared_ptr<const steps::AlignmentOutcome> outcome);
  void begin(steps::PreparedTreatment& prepared);
  void finish();
  void refuse(const QString& words, const std::string& failure);

  const Services& services_;
  TaskRunner& tasks_;
  CamerasPresenter cameras_;
  Stage stage_ = Stage::opening;
  QString refusal_, play_refusal_, saved_as_;
  std::optional<steps::HomeCase> home_;
  std::optional<capture::Recording> recording_;  // played; empty with live cameras
  std::shared_ptr<steps::Treatment> treatment_;
  std::optional<steps::OtherCoilWatch> other_coil_;
  std::filesystem::path session_;
  std::optional<Timestamp> asked_to_finish_;
  std::optional<int> planned_;
  session::PulseCounts counts_;  // pulses of the ended session
  AsynchronousShutdown retirement_;
};

}  // namespace facenav::ui
