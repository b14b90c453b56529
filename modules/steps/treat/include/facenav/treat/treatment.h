#pragma once
// TREAT: opens what a session needs (case, cameras or a recording, coil, trackers) and runs it with its log.
// The window and `facenav track --pulses` use the same functions and differ only in their display.

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "facenav/align/align_from_capture.h"
#include "facenav/align/alignment_seen.h"
#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/casefile/protocol.h"
#include "facenav/coil_tracking/coil_card.h"
#include "facenav/links/pulse_source.h"
#include "facenav/report/session_notes.h"
#include "facenav/report/session_report.h"
#include "facenav/session/treatment_log.h"
#include "facenav/setup/cameras_learnt.h"
#include "facenav/treat/live_outputs.h"
#include "facenav/treat/pulse_fields.h"

namespace facenav::steps {

/// A recording that is played instead of cameras, and the coil in it.
struct TreatmentFilm {
  capture::Recording recording;
  coil_tracking::CoilModel coil;
  coil_tracking::CoilCard card;  // the coil's; for the default coil only its name
};
/// Opens a recording. The coil is that of its coil.json, else the default one. Throws Error.
TreatmentFilm openTreatmentFilm(const std::filesystem::path& folder);

/// A second coil that is tracked and guided in the same session, by its own marker.
struct SecondCoilChoice {
  coil_tracking::CoilModel coil;
  std::optional<session::ChosenTarget> target;  // its own; nothing: none
};

/// Coil that a source's pulses are given with, by the source's words ("udp:5005", "keyboard"). The empty word
/// is any other source. Only for a session with two coils; a source that is not named here has to say it with
/// each pulse.
using CoilOfSource = std::map<std::string, std::string>;

/// A clinician's decision to treat a case without a valid sign-off.
struct SignOffOverride {
  std::string by, reason;
};

struct TreatmentRequest {
  casefile::CaseStore store;
  capture::Recording recording;  // with live cameras: their rig
  /// True for live cameras: one that is unplugged reopens automatically (capture/returning_cameras.h).
  bool is_live = false;
  coil_tracking::CoilModel coil;
  std::shared_ptr<const AlignmentOutcome> alignment;
  /// Warning that the coil's calibration is old (coil_library.h). Logged.
  std::optional<std::string> coil_reminder = {};
  std::optional<SignOffOverride> override = {};
  /// Folder of an earlier session of the case to continue (session_return.h); empty: a new one. The alignment
  /// is then the case's own, and guidance is withheld until it is checked.
  std::filesystem::path goes_on = {};
  double speed = 1.0;                             // of a recording, relative to real time
  std::optional<std::string> focus_caution = {};  // coil_library.h; logged
  /// True if the alignment is an earlier one: guidance is withheld until it is checked.
  bool is_checked_first = false;
  /// Coil whose electric field is kept with each pulse, as efield::fieldCoil takes it.
  std::string field_coil = kUsualFieldCoil;
  /// Called at the end with results to store with the rig; may be null. Runs on the thread of end().
  std::function<void(const CamerasLearnt&)> keepLearnt = nullptr;
  std::optional<SecondCoilChoice> second = {};
  CoilOfSource coil_of_source = {};
  /// False: head and coil come from another tracker (served_tracker.h); there are no pictures.
  bool has_cameras = true;
  bool is_coil_served = false;  // true: the coil's pose comes from another tracker
};

/// Functions that open trackers and frames; a test replaces them.
struct TreatmentDevices {
  std::function<std::unique_ptr<session::Navigator>(const session::NavigatorSetup&)> makeNavigator;
  std::function<std::unique_ptr<capture::FrameSource>()> openSource;
};

/// Everything opened, nothing running.
struct PreparedTreatment {
  TreatmentRequest request;
  std::unique_ptr<session::Navigator> navigator;
  std::unique_ptr<capture::FrameSource> source;
};
/// Opens everything. Slow; for a worker thread. Throws Error: not signed off and no override, no face, a
/// camera that is busy.
PreparedTreatment prepareTreatment(const TreatmentRequest& request, const TreatmentDevices& devices);

/// A window's cameras, from their preview to the treatment. Both are null if a recording is played.
struct CameraTurnover {
  std::function<std::unique_ptr<capture::FrameSource>()> open;
  std::shared_ptr<const void> preview;  // keeps the cameras open until the treatment opens them
};
/// Opens everything for a window: with its navigator, and its cameras or the request's recording.
std::shared_ptr<PreparedTreatment> prepareTreatment(
    const TreatmentRequest& request,
    const std::function<std::unique_ptr<session::Navigator>(const session::NavigatorSetup&)>& makeNavigator,
    CameraTurnover& cameras);

/// Returns "aligned: 95 % within 1.4 mm at M1 (0.41 mm rms over 16000 points)", for log, window and command
/// line. `target` may be null; then, and if the bound is unknown, "aligned: 0.41 mm rms over 16000 points".
std::string alignmentWords(const AlignmentOutcome& alignment, const guidance::Target* target);
/// Returns the target with the error that the alignment predicts there; `alignment` may be null.
session::ChosenTarget chosenTarget(const guidance::Target& target, const AlignmentOutcome* alignment);

/// A running session and its log in the case. Used by one thread, except end() and keepReport().
class Treatment {
 public:
  /// Starts the session. Throws Error when the case cannot be written to; then nothing has started.
  Treatment(PreparedTreatment prepared, const std::optional<session::ChosenTarget>& target);
  ~Treatment();
  Treatment(const Treatment&) = delete;
  Treatment& operator=(const Treatment&) = delete;

  /// Planned pulses of this session, by the target's own dose, else the case's protocol; nothing: not given.
  std::optional<int> plannedPulses() const { return planned_pulses_; }

  // The next functions may be called until end().
  session::Session& session() { return *session_; }
  const session::Session& session() const { return *session_; }
  session::TreatmentLog& log() { return *log_; }
  const session::TreatmentLog& log() const { return *log_; }
  /// Sets the target; nothing: none. `name` is logged.
  void chooseTarget(const std::optional<session::ChosenTarget>& target, const std::string& name);
  /// Sets a target of the case's current plan. Throws Error if there is none of that name.
  void chooseTargetNamed(const std::string& name);

  /// Sets the coil that is tracked from the next frame on; the log records it with that frame. Throws Error
  /// if its marker is that of the coil in use, because a picture could not distinguish them.
  void chooseCoil(const coil_tracking::CoilModel& coil);
  const std::string& coilName() const { return coil_.name; }
  /// Name of the second coil; empty: there is none.
  std::string secondCoilName() const { return second_ ? second_->coil.name : std::string(); }
  /// Sets the second coil's target; nothing: none. `name` is logged.
  void chooseSecondTarget(const std::optional<session::ChosenTarget>& target, const std::string& name);
  /// Sets a target of the case's current plan for the second coil. Throws Error if there is none of that
  /// name.
  void chooseSecondTargetNamed(const std::string& name);
  /// True if it is known which coil a pulse of this source is given with.
  bool knowsCoilOf(const std::string& source) const { return !second_ || !coilOf(source).empty(); }

  /// Adds a source of pulses, besides the keyboard. Faults of a source are logged as events. Throws Error,
  /// and adds none, if it cannot be opened.
  void listen(std::unique_ptr<links::PulseSource> source);
  /// Adds a source by its words. If it cannot be opened, the session continues without it; the fault is
  /// logged and returned.
  std::optional<std::string> tryToListen(const std::string& source);
  /// Stops these sources.
  void stopListening();
  /// Sends every state and pulse to these outputs from now on; null: to none.
  void sendTo(std::shared_ptr<LiveOutputs> outputs);
  /// Adds a pulse by the window's key or button, pressed at that time.
  /// `coil`: name of the coil that gave it; empty: the source's (CoilOfSource).
  void pressPulse(Timestamp at = Timestamp::now(), const std::string& coil = {}) {
    keyboard_.press(at, coil);
  }
  /// Adds a pulse that another program reports; thread-safe.
  void takePulse(const links::PulseTrigger& pulse) { listenerFor(pulse.source).pulse(pulse); }
  /// Sets the intensity of the next pulses whose source does not send it; % of the maximal output.
  void setIntensity(std::optional<double> intensity_pct);
  /// Pauses with a reason, or resumes. A pulse in a pause is kept, marked, and never on target.
  void pause(const std::string& reason) { log_->pause(reason); }
  void resume() { log_->resume(); }
  bool isPaused() const { return log_->pauses().isPaused(); }
  /// Measures for two seconds whether the MRI is still aligned with the face. The finding appears in the next
  /// states (NavigationState::check) and in the log; a failed check withholds guidance until one passes.
  void checkRegistration();
  /// Adds a person's verdict on the coil's tip, held to nose or ear, or on a spot picked in a picture; logged
  /// with its distances. Wrong: guidance is withheld for the rest of the session, and the case is no longer
  /// aligned (casefile::setAlignmentAside).
  void judgeTip(TipVerdict verdict, const guidance::TipReading& reading);
  /// Makes the check for the case's scalp; takes a second.
  std::shared_ptr<const guidance::TipCheck> makeTipCheck() const;
  /// Point of the coil in use that is held to the face.
  const Point<Coil>& tip() const { return coil_.tip; }
  /// The cameras' calibration.
  const cameras::StereoRig& rig() const { return rig_; }
  /// True if the last check, or the alignment, is older than RegistrationCheckRules allows.
  bool isCheckDue();

  /// Stops, stores key frames of the face with the case, and closes the log. `why`: what ended it if nobody
  /// asked for the end (logged, and in the report); empty: a person did. It waits for a camera that hangs, so
  /// a window calls it on another thread. Only keepReport() may follow.
  void end(const std::string& why = {});
  /// Writes the report, after end(). A failure is logged as a warning; `facenav report` writes it again.
  void keepReport(const report::ReportOptions& options = {}) const;

 private:
  session::TreatmentLogOptions logOptions(const std::filesystem::path& goes_on);
  links::PulseListener listenerFor(const std::string& source);
  void plan(const guidance::Target* target);
  void noteOtherCoil();
  void noteSecond();
  std::string coilOf(const std::string& source) const;

  std::filesystem::path case_folder_, session_folder_;
  cameras::StereoRig rig_;
  coil_tracking::CoilModel coil_;
  std::optional<SecondCoilChoice> second_;
  CoilOfSource coil_of_source_;
  bool has_cameras_;
  std::optional<guidance::Target> target_;
  std::function<void(const CamerasLearnt&)> keepLearnt_;
  std::shared_ptr<const AlignmentOutcome> alignment_;
  std::shared_ptr<session::Session> session_;
  std::unique_ptr<PulseFieldKeeper> fields_;  // outlives the log, which tells it the pulses
  std::unique_ptr<session::TreatmentLog> log_;
  std::atomic<double> intensity_pct_{-1};  // < 0: unknown; read by the sources' threads
  std::shared_ptr<LiveOutputs> outputs_;   // null: none; read by the sources' threads, atomically
  std::optional<casefile::Protocol> protocol_;
  std::optional<int> planned_pulses_;
  Timestamp checked_ = Timestamp::now();  // time of the last registration check
  int last_check_ = 0;
  links::KeyboardSource keyboard_;
  std::vector<std::unique_ptr<links::PulseSource>> sources_;  // they stop before the log ends
};

}  // namespace facenav::steps
