#pragma once
// TREAT from the command line: a recording played as if it were live, guided to a target, with pulses from
// outside, logged into the case like a session of the window (`facenav track --pulses`).

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/poses_csv.h"
#include "facenav/workflow/registrations.h"
#include "facenav/workflow/treatment.h"

namespace facenav::workflow {

struct TreatRecordingRequest {
  std::filesystem::path recording, case_folder;
  std::optional<std::filesystem::path> coil_file;   // nothing: as openTreatmentFilm
  std::string aligner, head_tracker, coil_tracker;  // registered names
  std::string target;                               // empty: the case's first one
  std::vector<std::string> sources;                 // words of links::openPulseSource
  std::optional<double> intensity_pct;
  std::optional<SignOffOverride> override;
  bool goes_on = false;      // with an earlier session of the case, on the case's own alignment
  std::string session = {};  // which; empty: the newest
  double speed = 1.0;        // relative to real time
  int passes = 1;            // through the recording, forwards and backwards in turn; 0: without end
  /// Called every few milliseconds while the session runs; false: it ends. May be empty.
  std::function<bool(Treatment&)> look = {};
};

struct TreatRecordingOutcome {
  std::filesystem::path session;
  session::PulseCounts pulses;
  int frames = 0;
  double processing_ms_median = 0, processing_ms_p99 = 0;
};

/// Ends with the recording, or when `monitor` is cancelled; the session is kept in both cases. Throws Error:
/// not signed off, not aligned, no such target, a source that cannot be opened.
TreatRecordingOutcome treatRecording(const Registrations& methods, const TreatRecordingRequest& request,
                                     TaskMonitor& monitor);

}  // namespace facenav::workflow
