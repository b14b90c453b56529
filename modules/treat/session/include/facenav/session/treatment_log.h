#pragma once
// TreatmentLog: writes the states of a running Session into sessions/<UTC time>/ of the case (poses.csv,
// guidance.csv, events.jsonl, pulses.jsonl). It has its own threads, so that neither tracking nor the window
// nor a pulse that needs its frame waits for the disk. It logs losses, finds, faults and the recording's end
// by itself; the caller adds pulses, chosen targets and overrides. A full disk does not end the session: the
// log reports it and resumes as soon as it can. It also reports a changed clock and a removed folder.

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "facenav/session/evidence_keeper.h"
#include "facenav/session/pause_times.h"
#include "facenav/session/pulse_keeper.h"
#include "facenav/session/session.h"

namespace facenav::session {

struct TreatmentLogOptions {
  /// Cameras of the pictures stored with each pulse (evidence/). Nothing: no pictures are stored.
  std::optional<cameras::StereoRig> evidence_rig = {};
  /// Folder of an earlier session of the case to continue; empty: a new one. Pulse numbers, frames and times
  /// continue those of its files.
  std::filesystem::path goes_on = {};
  /// Called for each pulse that has its pose, as PulseKeeper::Placed; may be empty.
  PulseKeeper::Placed placed = {};
  /// Clock for the time of day; a test replaces it.
  std::function<std::chrono::system_clock::time_point()> clock = [] {
    return std::chrono::system_clock::now();
  };
};

class TreatmentLog {
 public:
  /// Starts logging. Only the log may take() states of `session`. Its threads read the session and keep it
  /// alive until the log is destroyed. `scalp`: for the gap of each pulse; may be null. Throws Error when the
  /// case folder cannot be written to.
  TreatmentLog(std::shared_ptr<Session> session, const std::filesystem::path& case_folder,
               std::shared_ptr<const registration::ScalpField> scalp = nullptr,
               const TreatmentLogOptions& options = {});
  /// Writes the rest, syncs it to the disk and joins.
  ~TreatmentLog();
  TreatmentLog(const TreatmentLog&) = delete;
  TreatmentLog& operator=(const TreatmentLog&) = delete;

  /// Adds an event; returns at once. Must not contain a patient's name.
  void addEvent(const std::string& event, const std::string& detail = {});
  /// Adds a TMS pulse; returns at once. A second trigger within the source's dead time is logged as an event
  /// and not counted.
  void addPulse(PulseTrigger trigger = {});
  /// Begins and ends a pause; both are events. Pulses in it are kept and marked, and no guidance is logged.
  void pause(const std::string& reason);
  void resume();
  const PauseTimes& pauses() const;
  /// Time since the start, until the session's end, without pauses, s.
  double treated_s() const;
  /// Says why the session ends if nobody asked for its end ("the window was closed"). Empty: a person did.
  void endWith(const std::string& words);
  /// Number of the newest pulse, which may not be in the file yet; 0: none.
  int newestPulse() const;
  /// The newest pulse, if it has no answer of the muscle yet. Nothing if there is none to answer for.
  std::optional<AddedPulse> openPulse() const;
  /// Adds the response of the muscle to the newest pulse: its MEP, or yes or no; one a pulse. Stored with the
  /// pulse; returns at once. Returns false if no pulse is open, or for no MEP (0 to
  /// casefile::kLargestMep_uv).
  bool answerPulse(double mep_uv);
  bool answerPulse(bool has_twitched);
  /// Takes the last answer back. Returns false without one.
  bool takeBackAnswer();
  PulseCounts counts() const;
  /// Newest pulse with a verdict, about one frame after it.
  std::optional<JudgedPulse> lastPulse() const;
  /// Number of pulses in the session's file, on the disk. A pulse is written when the frame after it has
  /// arrived.
  int pulses() const;
  /// Calls PulseKeeper::takeKept.
  std::vector<casefile::Pulse> takeKept();
  /// Number of pulses that are not written yet.
  int pulsesWaiting() const;
  const std::filesystem::path& folder() const;
  /// Fault that prevents writing now (disk full, ..); empty: none.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
