#pragma once
// TreatPresenter: cameras (or a recording), align, guide: what the Treat page shows of a treatment
// (treat/treatment.h). Only a case with a valid sign-off, or an override with name and reason, can be
// treated.

#include <QObject>
#include <filesystem>
#include <memory>

#include "facenav/casefile/session_so_far.h"
#include "facenav/pictures/overlay_worker.h"
#include "facenav/treat/treatment.h"
#include "shell/asynchronous_shutdown.h"
#include "shell/case_model.h"
#include "shell/services.h"
#include "shell/shown_words.h"
#include "shell/task_runner.h"
#include "treat/aligned_head.h"
#include "treat/cameras_presenter.h"
#include "treat/followed_coil.h"
#include "treat/offers_presenter.h"
#include "treat/read_out.h"
#include "treat/second_coil_choice.h"
#include "treat/tracker_presenter.h"

namespace facenav::ui {

class TreatPresenter : public QObject {
  Q_OBJECT

 public:
  /// `draw`: draws the camera overlays, on its own thread; if empty, pictures/camera_overlay.h is used.
  TreatPresenter(const Services& services, CaseModel& model, TaskRunner& tasks, QObject* parent = nullptr,
                 pictures::OverlayWorker::Draw draw = {});
  ~TreatPresenter() override;

  /// Step 1: two live cameras.
  CamerasPresenter& cameras() { return cameras_; }
  /// Step 1: another tracker in place of cameras.
  TrackerPresenter& tracker() { return tracker_; }
  /// True if head and coil come from another tracker.
  bool hasTracker() const { return tracker_.isOpen(); }
  /// Step 1: opens and checks a recording folder.
  void openRecording(const QString& folder);
  /// Step 2: aligns from the capture pair. Starts step 3 afterwards if `then_start`.
  /// `is_patient_confirmed`: the answer to personUnclear().
  void align(bool then_start, bool is_patient_confirmed = false);
  /// Step 3: runs from the cameras, or from the recording as if it were live.
  void start();
  /// Continues an earlier session of the case: its alignment, its target, its counts. Guidance is withheld
  /// until the face was measured against that alignment. Needs cameras or a recording.
  void goOn(const casefile::SessionSoFar& session);
  /// Stops guiding; the session goes on, paused, until guide() or end().
  void stopGuiding();
  void guide() { resume(); }
  /// Asks for the end: guiding stops until end() or cancelEnd().
  void askEnd();
  void cancelEnd();
  bool isEnding() const { return is_ending_ && hasSession(); }
  /// Ends the session; log and report are written. Notes pain afterwards and adverse events; empty: not
  /// asked, none. sessionEnded() follows when the report is there.
  void end(const QString& pain_after = {}, const QString& adverse = {});
  /// Ends a session for another reason than the operator's wish; `why` is logged.
  void stop(const std::string& why);
  void chooseTarget(const QString& name);
  /// Names of the coils to choose from: the recording's own one, then those of the library.
  QStringList coils() const { return coil_.names(); }
  QString coilName() const { return coil_.name(); }
  /// Follows this coil from now on, also while guidance runs. A coil of the library is remembered.
  void chooseCoil(const QString& name);
  /// The second coil of the next session, or of the running one.
  const SecondCoilChoice& secondCoil() const { return second_; }
  void chooseSecondCoil(const QString& name);
  void chooseSecondTarget(const QString& name);
  void choosePulseCoil(const QString& coil);
  /// Names of the plan's targets.
  QStringList targetNames() const;
  /// Reminds that the target was found with another coil, or that the coil's calibration is old or not
  /// recorded; empty if neither applies.
  QString coilReminder() const { return coil_.reminder(target()); }
  /// Records an override in the case and in the session's log. Refused without name and reason.
  void overrideSignOff(const QString& by, const QString& reason);
  /// Guides to a place outside the plan (a site of a hunting grid); empty: to the chosen target again.
  void guideTo(const std::optional<guidance::Target>& site);

  // The functions of this group work only while guidance runs; else they do nothing, or return false.
  /// Stores a TMS pulse, given at that time, with the coil's pose.
  void countPulse(Timestamp at = Timestamp::now());
  /// The newest pulse, if the muscle's response to it is not stored yet.
  std::optional<session::AddedPulse> openPulse() const;
  /// Number of the newest pulse; 0: none.
  int newestPulse() const;
  /// Stores the muscle's response to the newest pulse, one a pulse.
  bool answerPulse(double mep_uv);
  bool answerPulse(bool has_twitched);
  bool takeBackAnswer();
  void pause(const QString& reason);
  void resume();
  bool isPaused() const { return isRunning() && treatment_->isPaused(); }
  /// True while a person is guided: a session runs and is not paused.
  bool isGuiding() const { return isRunning() && !treatment_->isPaused(); }
  /// The session's states to wait for on another thread while a person is guided; null: nobody is.
  std::shared_ptr<const LatestValue<session::NavigationState>> guidedStates() const {
    return isGuiding() ? treatment_->session().states() : nullptr;
  }
  /// "PAUSED: coil too warm", or empty.
  QString pauseWords() const;
  /// Length of the pause under way, s.
  double pauseLength_s() const;
  /// Measures the registration again; the result is in the next states, and in the log.
  void checkRegistration();
  /// True if the last check, or the alignment, is too long ago.
  bool isCheckDue() const { return isRunning() && treatment_->isCheckDue(); }

  /// Sets the intensity of the following pulses, % of the maximal output; remembered until the window closes.
  void setIntensity(std::optional<double> intensity_pct);
  std::optional<double> intensity() const { return intensity_pct_; }
  /// Sets the source of pulses beside the keyboard, as links::openPulseSource reads it; empty: none.
  /// Remembered, and used at once by a running session. Returns false, after refused(), if it is invalid.
  bool setPulseSource(const QString& words);
  QString pulseSource() const { return pulse_source_; }
  /// Sends the poses of this session and the next ones to outputs as links::openLiveOutput reads them, with
  /// blanks or commas between them; empty: nowhere. Those that are open stay so. Not remembered. Returns
  /// false, after refused(), if one cannot be opened. `accepts`: takes targets and commands from clients,
  /// too.
  bool sendTo(const QString& words, bool accepts = false);
  /// Obeys what clients sent since the last call. Commands need a running session; targets are offered at any
  /// time. Returns the newest line about it; empty if nothing came.
  QString obeyOrders();
  /// The targets that clients offer.
  OffersPresenter& offers() { return offers_; }
  bool isSending() const { return !outputs_->isEmpty(); }
  /// The open outputs, by their words.
  QStringList sendsTo() const;
  /// Outputs to offer beside the server, in the same words. Remembered; switched off at each start.
  QString otherOutputs() const;
  /// Returns false, after refused(), if they are not understood.
  bool setOtherOutputs(const QString& words);
  /// Who is connected, one line each.
  QStringList receivers() const;
  /// Logs an event of the running session, or of this window's last one. Returns false if there is none.
  bool note(const QString& event, const QString& detail);

  session::PulseCounts pulseCounts() const {
    return treatment_ ? treatment_->log().counts() : session::PulseCounts();
  }
  /// Number of pulses by the target's dose or the case's protocol; empty without a goal.
  std::optional<int> plannedPulses() const { return treatment_ ? treatment_->plannedPulses() : std::nullopt; }
  /// The newest pulse with a verdict; empty if there is none.
  std::optional<session::JudgedPulse> lastPulse() const {
    return treatment_ ? treatment_->log().lastPulse() : std::nullopt;
  }

  bool mayTreat() const { return model_.mayBeTreated(); }
  /// Number of pulses in the session's file; a pulse is written with the frame after it, at the latest after
  /// half a second.
  int pulses() const { return treatment_ ? treatment_->log().pulses() : 0; }
  /// Time from the start of guidance until its end, without pauses, "00:07:31"; empty before.
  QString sessionTime() const;
  /// "00:07:31, 40 pulses of 50: 38 on target, 2 outside"; empty without a session.
  QString summary() const;
  /// True from a session's start until end() or stop(), also after its recording's end.
  bool hasSession() const { return treatment_ != nullptr; }
  /// Why the session's log stopped; empty if it did not.
  QString logFailure() const { return treatment_ ? shownWords(treatment_->log().failure()) : QString(); }
  /// True if cameras are open or a recording is loaded.
  bool hasRecording() const { return recording_.has_value(); }
  bool isLive() const { return is_live_; }
  /// True if everything needed to align is there.
  bool canAlign() const;
  bool canGoOn() const {
    return recording_ && !hasTracker() && mayTreat() && !isRunning() && !tasks_.isRunning() &&
           withheldWords().isEmpty() && otherChoiceWords().isEmpty();
  }
  /// Fault of the live cameras, or the fault or corrected motion that the last session found; empty if none.
  QString rigFault() const { return withheldWords().isEmpty() ? rig_fault_ : withheldWords(); }
  /// Why alignment and guidance with the live cameras are withheld until repair; empty if they are not.
  QString withheldWords() const { return is_live_ ? cameras_.rigFault() : QString(); }
  /// Warning that the chosen cameras or calibration differ from the opened ones, to which pictures and
  /// alignment belong. Empty if they are the same.
  QString otherChoiceWords() const { return is_live_ ? cameras_.otherChoiceWords() : QString(); }
  /// What a click started and is not done yet, "ALIGNING: ..."; empty if nothing.
  QString doingWords() const { return tasks_.isRunning() ? doing_ : QString(); }
  /// True if aligned. An alignment that was judged wrong does not count: the next session needs another one.
  bool isAligned() const { return aligned_.outcome != nullptr && !is_judged_wrong_; }
  bool isRunning() const { return treatment_ && !treatment_->session().hasEnded(); }
  /// The recording reached its end, or a fault stopped the session.
  bool hasEnded() const { return treatment_ && treatment_->session().hasEnded(); }
  /// Folder of the recording used in place of cameras; empty if none.
  QString recordingFolder() const;
  QString recordingWords() const;
  /// "aligned: 95 % within 1.4 mm at M1 (..)", "not aligned in this session". The header shows the same
  /// words.
  QString alignmentWords() const;
  QString targetName() const { return target_; }
  /// The target guided to: the chosen one, or the site of a hunting grid. May be null.
  const guidance::Target* target() const;

  /// Bound of the error at a target that 95 of 100 such alignments keep, mm; empty without an alignment.
  /// Assumes cameras positioned as calibrated: the session withholds poses if the coil's marker shows
  /// otherwise.
  std::optional<double> errorBound95_mm(const guidance::Target& target) const {
    if (!isAligned()) return std::nullopt;
    return aligned_.outcome->errorBound_mm(target);
  }

  /// The MRI's skin and the check of the coil's tip, for the alignment in use; null members if none.
  const steps::AlignmentSeen& alignmentSeen() const { return aligned_.seen; }
  /// The MRI's skin over the pictures of the alignment; null if none.
  const std::shared_ptr<const pictures::CameraOverlay>& alignmentPicture() const { return aligned_.picture; }
  /// True while the skin is drawn over the live pictures: from an alignment on, until it is switched off.
  bool showsSkin() const { return shows_skin_; }
  void showSkin(bool is_shown);
  /// Point of the coil to hold to the face.
  const Point<Coil>& tip() const { return coil_.model().tip; }
  /// Rig of the cameras or the recording; null if none.
  const cameras::StereoRig* rig() const { return recording_ ? &recording_->rig : nullptr; }
  /// Draws a spot over the live pictures with the skin; empty: none.
  void showSpot(const std::optional<Point<Mri>>& spot) { spot_ = spot; }
  /// Logs the judgement; a wrong one withholds guidance, and the head must be aligned again.
  void judgeTip(steps::TipVerdict verdict, const guidance::TipReading& reading);

  /// The newest state; everything is lost in it if nothing runs.
  std::shared_ptr<const session::NavigationState> state() const;
  /// Requests both camera overlays of `state`; overlayDrawn() delivers them.
  void askOverlay(std::shared_ptr<const session::NavigationState> state);

 signals:
  void changed();
  void refused(const QString& words);
  /// The face fits the case, but is too coarse to tell people apart: a person is to confirm the patient, and
  /// then align(then_start, true). `words`: why.
  void personUnclear(const QString& words, bool then_start);
  /// The session of that name was ended by end(), and its report is written.
  void sessionEnded(const QString& name);
  void overlayDrawn(std::shared_ptr<const facenav::pictures::DrawnOverlay> drawn);

 private:
  void startWith(const std::filesystem::path& goes_on);
  /// Starts a task; `doing`: what the page says until it is done.
  void startTask(const QString& title, const QString& doing, TaskRunner::Work work);
  /// Refuses with words if the cameras are not those that were opened, or have moved. Returns false
  /// otherwise.
  bool refuseCameras();
  void use(const AlignedHead& aligned);
  void begin(steps::PreparedTreatment& prepared);
  void useCameras();
  void useTracker();
  void alignByFile();
  void forgetCameras();
  void forgetCase();
  void listen();
  void endSession(const std::string& why, std::function<void()> then = {});
  static constexpr const char* kPulseSource = "treat/pulses";  // in the settings
  static constexpr const char* kOtherOutputs = "treat/outputs";
  std::optional<session::ChosenTarget> chosen() const;

  const Services& services_;
  CaseModel& model_;
  TaskRunner& tasks_;
  CamerasPresenter cameras_;
  TrackerPresenter tracker_;
  std::optional<capture::Recording> recording_;  // with live cameras: the rig and the captured images
  bool is_live_ = false;
  mutable QString rig_fault_;
  FollowedCoil coil_;
  SecondCoilChoice second_;
  AlignedHead aligned_;
  bool is_judged_wrong_ = false;  // judgement of aligned_ by a person; until the head is aligned again
  bool shows_skin_ = true;
  bool is_ending_ = false, stopped_for_end_ = false;
  std::optional<Point<Mri>> spot_;
  std::shared_ptr<steps::Treatment> treatment_;  // null if none was started
  OffersPresenter offers_;                       // outlives the outputs, whose server hands orders over
  std::shared_ptr<steps::LiveOutputs> outputs_ = std::make_shared<steps::LiveOutputs>();
  AsynchronousShutdown retirement_;
  std::filesystem::path last_session_;
  QString target_, pulse_source_, doing_;
  std::optional<guidance::Target> site_;
  std::optional<double> intensity_pct_;
  pictures::OverlayWorker overlays_;
};

}  // namespace facenav::ui
