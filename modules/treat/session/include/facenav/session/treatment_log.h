#pragma once
// TreatmentLog: writes what a running Session does into sessions/<UTC time>/ of the case (poses.csv,
// guidance.csv, events.jsonl, pulses.jsonl). It has its own threads, so that neither tracking nor the window
// nor a pulse that needs its frame waits for the disk. It notes losses, finds, faults and the recording's end
// by itself; the caller adds pulses, chosen targets and overrides. A disk that is full ends nothing: it is
// said, and what follows is logged as soon as it can be. So is a clock that was set, and a folder that was
// removed.

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "facenav/session/evidence_keeper.h"
#include "facenav/session/pulse_keeper.h"
#include "facenav/session/session.h"

namespace facenav::session {

struct TreatmentLogOptions {
  /// The cameras: both pictures of each pulse's frame are kept (evidence/). Nothing: no pictures are kept.
  std::optional<cameras::StereoRig> evidence_rig = {};
  /// The folder of an earlier session of the case that is gone on with; empty: a new one. Its pulses are
  /// counted on, and frames and times follow those of its files.
  std::filesystem::path goes_on = {};
  /// The time of day; a test replaces it.
  std::function<std::chrono::system_clock::time_point()> clock = [] {
    return std::chrono::system_clock::now();
  };
};

class TreatmentLog {
 public:
  /// Only the log may take() states of `session`. Its threads read the session until the log is destroyed and
  /// keep it alive until then. `scalp`: for the gap of each pulse; may be null. Throws Error when the case
  /// folder cannot be written to.
  TreatmentLog(std::shared_ptr<Session> session, const std::filesystem::path& case_folder,
               std::shared_ptr<const registration::ScalpField> scalp = nullptr,
               const TreatmentLogOptions& options = {});
  /// Writes what is left, syncs it to the disk and joins.
  ~TreatmentLog();
  TreatmentLog(const TreatmentLog&) = delete;
  TreatmentLog& operator=(const TreatmentLog&) = delete;

  /// Returns at once. Must not contain a patient's name.
  void addEvent(const std::string& event, const std::string& detail = {});
  /// Keeps a TMS pulse; returns at once. A second trigger within the source's dead time is noted as an event
  /// and not counted.
  void addPulse(const PulseTrigger& trigger = {});
  /// What the muscle did at the newest pulse: its MEP, or yes or no. Kept with the pulse; returns at once.
  /// False: there is no pulse yet, or no such MEP (0 to casefile::kLargestMep_uv).
  bool answerPulse(double mep_uv);
  bool answerPulse(bool has_twitched);
  PulseCounts counts() const;
  /// The newest pulse with a verdict, about one frame after it.
  std::optional<JudgedPulse> lastPulse() const;
  /// Pulses that are in the session's file, on the disk. A pulse gets there when the frame after it has come.
  int pulses() const;
  /// As PulseKeeper::takeKept.
  std::vector<casefile::Pulse> takeKept();
  /// Pulses that are not there yet.
  int pulsesWaiting() const;
  const std::filesystem::path& folder() const;
  /// Why nothing can be written now (disk full, ..); empty if it can.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
