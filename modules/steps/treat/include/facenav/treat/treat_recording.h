#pragma once
// TREAT from the command line: guides live cameras, or a recording played as if it were live, to a target,
// with pulses from outside, logged into the case like a session of the window (`facenav track --pulses`,
// `track --live`, `guide --live`).

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/poses_csv.h"
#include "facenav/methods/registrations.h"
#include "facenav/treat/treatment.h"

namespace facenav::steps {

/// Live cameras instead of a recording.
struct LiveCameras {
  cameras::StereoRig rig;
  std::function<std::unique_ptr<capture::FrameSource>()> open;  // called again after they were away
  double seconds = 0;                                           // 0: without end
  std::function<void(const CamerasLearnt&)> keepLearnt;         // stores it at the end; may be null
};

/// Head and coil from another tracker, without cameras (served_tracker.h, tracker_alignment.h).
struct OtherTracker {
  std::string words;                // "igtl://HOST[:PORT]/NAME" of the coil
  std::string head, second_coil;    // names of their poses at the same server; second_coil: may be empty
  std::filesystem::path alignment;  // file
  double seconds = 0;               // 0: without end
};

/// Trackers and frames of a session without cameras.
TreatmentDevices devicesOf(const OtherTracker& tracker);

struct TreatRecordingRequest {
  std::filesystem::path recording, case_folder;
  std::optional<std::filesystem::path> coil_file;   // nothing: as in openTreatmentFilm
  std::string aligner, head_tracker, coil_tracker;  // registered names
  std::string target;                               // empty: the case's first one
  std::vector<std::string> sources;                 // words of links::openPulseSource
  std::optional<double> intensity_pct;
  std::optional<SignOffOverride> override;
  bool goes_on = false;      // continues an earlier session of the case, on the case's own alignment
  std::string session = {};  // its name; empty: the newest
  std::string field_coil = kUsualFieldCoil;  // TreatmentRequest::field_coil
  double speed = 1.0;                        // relative to real time
  int passes = 1;  // through the recording, alternately forwards and backwards; 0: endless
  /// Called every few milliseconds while the session runs; return false to end it. May be empty.
  std::function<bool(Treatment&)> look = {};
  /// Makes the tracker of the coil; null: the one named coil_tracker.
  std::function<std::unique_ptr<coil_tracking::CoilTracker>()> makeCoilTracker = nullptr;
  std::shared_ptr<LiveOutputs> outputs = nullptr;  // where states and pulses are sent; null: nowhere
  /// Uses live cameras. The alignment is then the case's own, and guidance is withheld until it is checked.
  std::optional<LiveCameras> live = {};
  std::optional<OtherTracker> other_tracker = {};              // in place of cameras and recording
  std::optional<std::filesystem::path> second_coil_file = {};  // a second coil; nothing: none
  std::string second_target = {};                              // its target; empty: none
  CoilOfSource coil_of_source = {};
  bool is_patient_confirmed = false;  // as in AlignOrder

  /// True if it goes on until it is ended, or for a time.
  bool isLive() const { return live || other_tracker; }
  double seconds() const { return live ? live->seconds : other_tracker ? other_tracker->seconds : 0; }
};

struct TreatRecordingOutcome {
  std::filesystem::path session;
  session::PulseCounts pulses;
  int frames = 0;
  double processing_ms_median = 0, processing_ms_p99 = 0;
  std::string failure = {};  // why it ended early; empty: it did not
};

/// Status in one line: "on target, 1.2 mm, 3 deg; 12 pulses". A loss replaces the figures.
std::string inWords(const Treatment& treatment, const session::NavigationState& state);

/// Treats until the recording or the live time ends, or `monitor` is cancelled; the session is stored in each
/// case. Throws Error: not signed off, not aligned, no such target, a source that cannot be opened.
TreatRecordingOutcome treatRecording(const Registrations& methods, const TreatRecordingRequest& request,
                                     TaskMonitor& monitor);

}  // namespace facenav::steps
