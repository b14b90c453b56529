// facenav track RECORDING [--case CASE] [--coil coil.json] -o poses.csv; with --pulses as a session of the
// case

#include <cmath>
#include <cstdio>

#include "commands/coil_option.h"
#include "commands/commands.h"
#include "commands/session_commands.h"
#include "facenav/core/error.h"
#include "facenav/workflow/session_return.h"
#include "facenav/workflow/track_recording.h"
#include "facenav/workflow/treat_recording.h"

namespace facenav::app {
namespace {

/// What makes a session of it.
struct Treated {
  std::vector<std::string> sources;
  std::string target, by, reason;
  std::optional<double> intensity_pct;
  bool goes_on = false, has_commands = false;
  std::string session;
  std::filesystem::path coil_library;
  double speed = 1;
  int passes = 1;
};

/// A session that was cut off is not forgotten in silence.
void noteInterrupted(const std::filesystem::path& case_folder, const Treated& treated,
                     const Context& context) {
  if (treated.goes_on || context.is_quiet) return;
  if (const auto session = workflow::interruptedSession(case_folder))
    std::fprintf(stderr, "note: %s; --continue goes on with it\n",
                 workflow::inWords(*session, workflow::plannedPulses(case_folder, session->target)).c_str());
}

void treat(const workflow::TrackRequest& track, const Treated& treated, const std::filesystem::path& output,
           Context& context) {
  if (!track.case_folder) throw Error("pulses belong to a case", {}, "give it with --case");
  workflow::TreatRecordingRequest request{
      track.recording,    *track.case_folder, track.coil_file, track.aligner,         track.head_tracker,
      track.coil_tracker, treated.target,     treated.sources, treated.intensity_pct, {}};
  if (!treated.reason.empty()) request.override = {treated.by, treated.reason};
  request.goes_on = treated.goes_on;
  request.session = treated.session;
  request.speed = treated.speed;
  request.passes = treated.passes;
  SessionCommands commands(treated.coil_library);
  if (treated.has_commands)
    request.look = [&commands](workflow::Treatment& treatment) { return commands.look(treatment); };
  noteInterrupted(*track.case_folder, treated, context);
  const auto outcome = workflow::treatRecording(context.registrations, request, context.monitor);
  casefile::writePoses(casefile::readPoses(outcome.session / "poses.csv"), output);
  if (context.is_quiet || treated.has_commands) return;
  const auto& pulses = outcome.pulses;
  std::printf("session %s: %d pulses on target, %d outside, %d with head or coil lost\n",
              outcome.session.filename().c_str(), pulses.on_target, pulses.outside, pulses.lost);
  std::printf("%d frames; %.1f ms a frame (median), %.1f ms (p99)\n", outcome.frames,
              outcome.processing_ms_median, outcome.processing_ms_p99);
}

void addSessionOptions(CLI::App& verb, Treated& treated) {
  auto* goes_on = verb.add_flag("--continue", treated.goes_on,
                                "with --pulses: goes on with the case's newest session, on the case's own "
                                "alignment, which is checked first; pulses are counted on");
  verb.add_option("--session", treated.session, "with --continue: another session, or how its name begins")
      ->needs(goes_on);
  verb.add_flag(
      "--commands", treated.has_commands,
      "with --pulses: takes commands on standard input, and tells each pulse that is on the disk as "
      "a line of JSON: " +
          sessionCommandWords());
  verb.add_option("--speed", treated.speed, "with --pulses: plays slower or faster than it was")
      ->check(CLI::Range(0.05, 20.0))
      ->capture_default_str();
  verb.add_option(
          "--passes", treated.passes,
          "with --pulses: plays so often, forwards and backwards in turn (a rehearsal); 0: without end")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
}

}  // namespace

void addTrack(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("track", "recording -> poses of head and coil, frame by frame");
  auto request = std::make_shared<workflow::TrackRequest>();
  auto output = std::make_shared<std::filesystem::path>();
  request->aligner = context.registrations.aligners.defaultName();
  request->head_tracker = context.registrations.head_trackers.defaultName();
  request->coil_tracker = context.registrations.coil_trackers.defaultName();
  verb->add_option("RECORDING", request->recording, "recording folder")->required();
  verb->add_option("--case", request->case_folder,
                   "case folder: poses in the MRI's frame, aligned from the recording's capture/");
  auto coil = std::make_shared<CoilChoice>();
  verb->add_option(
      "--coil", coil->words,
      "the coil: its name in the library, or its coil.json (without it: one 60 mm marker, 4x4_50, "
      "id 7)");
  addCoilLibraryOption(*verb, coil->library);
  verb->add_flag("--keep-looks", request->keeps_key_frames,
                 "keep with the case how the face looked, so that it is found at once in the next session");
  verb->add_option("-o,--output", *output, "poses.csv to write")->required();
  verb->add_option("--head-tracker", request->head_tracker,
                   "method: " + workflow::namesOf(context.registrations.head_trackers))
      ->capture_default_str();
  verb->add_option("--coil-tracker", request->coil_tracker,
                   "method: " + workflow::namesOf(context.registrations.coil_trackers))
      ->capture_default_str();
  verb->add_option("--aligner", request->aligner,
                   "method: " + workflow::namesOf(context.registrations.aligners))
      ->capture_default_str();
  auto treated = std::make_shared<Treated>();
  verb->add_option(
          "--pulses", treated->sources,
          "plays the recording as if live and logs a session in the case, with the pulses of this source: " +
              links::pulseSourceWords() + "; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--target", treated->target, "with --pulses: the target; default: the case's first one");
  verb->add_option("--intensity", treated->intensity_pct,
                   "with --pulses: % of the maximal output, where the source does not know it")
      ->check(CLI::Range(0.0, 100.0));
  auto* by = verb->add_option("--by", treated->by, "who overrides a missing sign-off");
  verb->add_option("--override", treated->reason, "with --pulses: treats a case without a sign-off; why")
      ->needs(by);
  addSessionOptions(*verb, *treated);
  verb->callback([&context, request, output, treated, coil] {
    treated->coil_library = workflow::coilLibrary(coil->library);
    if (!coil->words.empty()) request->coil_file = workflow::coilFileOf(coil->words, treated->coil_library);
    if (!treated->sources.empty()) return treat(*request, *treated, *output, context);
    const auto outcome = workflow::trackRecording(context.registrations, *request, context.monitor);
    casefile::writePoses(outcome.poses, *output);
    if (context.is_quiet) return;
    std::printf("%d frames: head tracked in %d, coil in %d; %.1f ms a frame (median), %.1f ms (p99)\n",
                outcome.frames, outcome.head_tracked, outcome.coil_tracked, outcome.processing_ms_median,
                outcome.processing_ms_p99);
    if (outcome.right_late_ms != 0)
      std::printf(
          "the right camera exposes %.1f ms %s the left one: allowed for; better a trigger for both\n",
          std::abs(outcome.right_late_ms), outcome.right_late_ms > 0 ? "after" : "before");
  });
}

}  // namespace facenav::app
