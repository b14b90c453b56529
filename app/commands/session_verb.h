#pragma once
// A session on the command line, from live cameras or from a recording played as if it were live: its
// options, and how it runs. `facenav track --pulses`, `track --live` and `guide --live` use it.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "commands/coil_option.h"
#include "commands/live_option.h"
#include "commands/output_option.h"
#include "facenav/treat/treat_recording.h"

namespace facenav::app {

struct SessionVerb {
  LiveChoice live;     // only its rig; empty: a recording is played
  double seconds = 0;  // duration with live cameras; 0: until Ctrl-C
  std::filesystem::path recording, case_folder;
  CoilChoice coil;
  std::string aligner, head_tracker, coil_tracker;  // registered names
  std::vector<std::string> sources;                 // sources of pulses
  std::string target, by, reason;
  std::optional<double> intensity_pct;
  std::string field_coil = steps::kUsualFieldCoil;
  bool goes_on = false, has_commands = false, is_patient_confirmed = false;
  std::string session;
  double speed = 1;
  int passes = 1;
  bool is_json = false;  // its result is printed as JSON
  OutputChoice outputs;
  std::string tracker;  // "igtl://HOST:PORT/NAME": the coil's pose; empty: the cameras'
  std::filesystem::path tracker_pose;
  std::string tracker_head, tracker_second;  // names of head and second coil there; empty: the cameras'
  std::filesystem::path tracker_alignment;
  std::string second_target;
  std::vector<std::string> pulse_coils;  // "SOURCE=COIL" or "COIL"
  /// True if there are no cameras: head and coil are another tracker's.
  bool isWithoutCameras() const { return !tracker_head.empty(); }
};

/// Adds --live, --rigs, --seconds.
void addLiveSessionOptions(CLI::App& verb, SessionVerb& session);
/// Adds --pulses, --intensity, --field-coil, --by, --override, --continue, --session, --commands, --tracker,
/// its further options, --second-target, --pulse-coil, --serve, --send.
void addSessionOptions(CLI::App& verb, SessionVerb& session);
/// Throws WrongUsage if an option of a session was given and no session runs. `starters`: the options that
/// start one in this verb.
void refuseIdleSession(const CLI::App& verb, const std::vector<std::string>& starters);
/// Runs until the end, Ctrl-C, or a command from standard input. Reports changes (lost, found, a camera away)
/// on stderr, one line each. The session is stored in each case. Throws Error.
steps::TreatRecordingOutcome runSession(const SessionVerb& verb, Context& context);
/// Prints pulses, frames and times in two lines, or as JSON.
void printSession(const steps::TreatRecordingOutcome& outcome, bool is_json);
/// Copies the session's table of the second coil beside `output`, if there is one.
void copySecondTable(const std::filesystem::path& table, const std::filesystem::path& output);
/// Throws Error if the session ended early. Call it after its results were written.
void requireWholeSession(const steps::TreatRecordingOutcome& outcome);

}  // namespace facenav::app
