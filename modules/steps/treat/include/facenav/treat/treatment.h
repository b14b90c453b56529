#pragma once
// TREAT: opens what a session needs (case, cameras or a recording, coil, trackers) and runs it with its log.
// The window and `facenav track --pulses` use the same functions; they only differ in what they show.

#include <atomic>
#include <filesystem>
#include <functional>
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
#include "facenav/session/treatment_log.h"
#include "facenav/setup/cameras_learnt.h"

namespace facenav::steps {

/// A recording that is played in place of cameras, and the coil filmed in it.
struct TreatmentFilm {
  capture::Recording recording;
  coil_tracking::CoilModel coil;
  coil_tracking::CoilCard card;  // of the coil; of the default one: only its name
};
/// The coil is that of coil.json in the recording, else the default one. Throws Error.
TreatmentFilm openTreatmentFilm(const std::filesystem::path& folder);

/// A clinician treats a case without a valid sign-off.
struct SignOffOverride {
  std::string by, reason;
};

struct TreatmentRequest {
  casefile::CaseStore store;
  capture::Recording recording;  // with live cameras: their rig
  /// Live cameras: one that is unplugged comes back by itself (capture/returning_cameras.h).
  bool is_live = false;
  coil_tracking::CoilModel coil;
  std::shared_ptr<const AlignmentOutcome> alignment;
  /// What a person must know of the coil: that its calibration is old (coil_library.h). Logged.
  std::optional<std::string> coil_reminder = {};
  std::optional<SignOffOverride> override = {};
  /// The folder of an earlier session of the case that is gone on with (session_return.h); empty: a new one.
  /// The alignment is then the case's own, and guidance is withheld until it is checked.
  std::filesystem::path goes_on = {};
  double speed = 1.0;                             // of a recording, relative to real time
  std::optional<std::string> focus_caution = {};  // coil_library.h; logged
  /// The alignment is of an earlier moment: guidance is withheld until it is checked.
  bool is_checked_first = false;
  /// Called at the end with what is worth keeping with a kept rig; may be null. On the thread of end().
  std::function<void(const CamerasLearnt&)> keepLearnt = nullptr;
};

/// How trackers and frames are opened; a test replaces them.
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
/// Slow; for a worker thread. Throws Error: not signed off and no override, no face, a camera that is busy.
PreparedTreatment prepareTreatment(const TreatmentRequest& request, const TreatmentDevices& devices);

/// A window's cameras, from their preview to the treatment. Both are null where a recording is played.
struct CameraTurnover {
  std::function<std::unique_ptr<capture::FrameSource>()> open;
  std::shared_ptr<const void> preview;  // holds the cameras until they are opened
};
/// The same for a window: with its navigator, and its cameras or the request's recording.
std::shared_ptr<PreparedTreatment> prepareTreatment(
    const TreatmentRequest& request,
    const std::function<std::unique_ptr<session::Navigator>(const session::NavigatorSetup&)>& makeNavigator,
    CameraTurnover& cameras);

/// "aligned: 0.41 mm rms over 16000 points, ±0.4 mm at M1", for log, window and command line. `target` may be
/// null.
std::string alignmentWords(const AlignmentOutcome& alignment, const guidance::Target* target);
/// With the error that the alignment predicts at the target; `alignment` may be null.
session::ChosenTarget chosenTarget(const guidance::Target& target, const AlignmentOutcome* alignment);

/// A running session and its log in the case. Used by one thread, except end() and keepReport().
class Treatment {
 public:
  /// Starts. Throws Error when the case cannot be written to; then nothing has started.
  Treatment(PreparedTreatment prepared, const std::optional<session::ChosenTarget>& target);
  ~Treatment();
  Treatment(const Treatment&) = delete;
  Treatment& operator=(const Treatment&) = delete;

  /// Pulses that the target's own dose, else the case's protocol, wants in this session; nothing: not stated.
  std::optional<int> plannedPulses() const { return planned_pulses_; }

  // Until end():
  session::Session& session() { return *session_; }
  const session::Session& session() const { return *session_; }
  session::TreatmentLog& log() { return *log_; }
  const session::TreatmentLog& log() const { return *log_; }
  /// `name` is logged; nothing: no target.
  void chooseTarget(const std::optional<session::ChosenTarget>& target, const std::string& name);
  /// A target of the case's plan, as it is there now. Throws Error if there is none of that name.
  void chooseTargetNamed(const std::string& name);

  /// Another coil is followed from the next frame on, and the log says from which. Throws Error where its
  /// marker is that of the coil in use: a picture could not tell them apart.
  void chooseCoil(const coil_tracking::CoilModel& coil);
  const std::string& coilName() const { return coil_.name; }

  /// The pulses of a source, from now on; beside it the keyboard is always there. What keeps a source from
  /// working is an event. Throws Error when it cannot be opened; none is added then.
  void listen(std::unique_ptr<links::PulseSource> source);
  /// The same by the source's words. A session goes on without a source that cannot be opened: that is
  /// logged, and returned in words.
  std::optional<std::string> tryToListen(const std::string& source);
  /// No more pulses from these sources.
  void stopListening();
  /// A pulse by the window's key or button.
  void pressPulse() { keyboard_.press(); }
  /// Of the following pulses, where their source does not know it; % of the maximal output.
  void setIntensity(std::optional<double> intensity_pct);
  /// Pauses with a reason, or goes on. Only an event: pulses are judged as ever.
  void pause(const std::string& reason);
  void resume();
  bool isPaused() const { return is_paused_; }
  /// Measures for two seconds whether the MRI is still aligned with the face. The finding is in the next
  /// states (NavigationState::check) and in the log; one that failed withholds guidance until one passes.
  void checkRegistration();
  /// What a person says of the coil's tip, held to nose or ear, or of a spot picked in a picture; logged with
  /// its distances. Wrong: guidance is withheld for the rest of the session, and the case is no longer
  /// aligned (casefile::setAlignmentAside).
  void judgeTip(TipVerdict verdict, const guidance::TipReading& reading);
  /// Of the case's scalp; takes a second.
  std::shared_ptr<const guidance::TipCheck> makeTipCheck() const;
  /// The point of the coil in use that is held to the face.
  const Point<Coil>& tip() const { return coil_.tip; }
  /// As the cameras were calibrated.
  const cameras::StereoRig& rig() const { return rig_; }
  /// It is asked for: the last one, or the alignment, is longer ago than RegistrationCheckRules says.
  bool isCheckDue();

  /// Stops, keeps the looks of the face with the case, and closes the log. It waits for a camera that hangs,
  /// so a window calls it on another thread. Nothing but keepReport() may follow.
  void end();
  /// After end(). A report that cannot be written is logged as a warning; `facenav report` makes it again.
  void keepReport() const;

 private:
  links::PulseListener listenerFor(const std::string& source);
  void plan(const guidance::Target* target);
  void noteOtherCoil();

  std::filesystem::path case_folder_, session_folder_;
  cameras::StereoRig rig_;
  coil_tracking::CoilModel coil_;
  std::optional<guidance::Target> target_;
  std::function<void(const CamerasLearnt&)> keepLearnt_;
  std::shared_ptr<const AlignmentOutcome> alignment_;
  std::shared_ptr<session::Session> session_;
  std::unique_ptr<session::TreatmentLog> log_;
  std::atomic<double> intensity_pct_{-1};  // < 0: not known; read by the sources' threads
  std::optional<casefile::Protocol> protocol_;
  std::optional<int> planned_pulses_;
  bool is_paused_ = false;
  Timestamp checked_ = Timestamp::now();  // the registration, last
  int last_check_ = 0;
  links::KeyboardSource keyboard_;
  std::vector<std::unique_ptr<links::PulseSource>> sources_;  // they stop before the log ends
};

}  // namespace facenav::steps
