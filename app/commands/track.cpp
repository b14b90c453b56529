// facenav track RECORDING [--case CASE] [--coil coil.json] -o poses.csv. With --pulses, or with --live RIG in
// place of the recording, it runs as a session of the case.

#include <cmath>
#include <cstdio>

#include "commands/commands.h"
#include "commands/confirmation_option.h"
#include "commands/session_verb.h"
#include "commands/two_coils.h"
#include "facenav/core/error.h"
#include "facenav/treat/track_recording.h"
#include "idle_options.h"
#include "json_output.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

/// Copies the options that the session shares with plain tracking.
void fillSession(const steps::TrackRequest& request, SessionVerb& session) {
  session.recording = request.recording;
  session.case_folder = request.case_folder.value_or(std::filesystem::path());
  session.aligner = request.aligner;
  session.head_tracker = request.head_tracker;
  session.coil_tracker = request.coil_tracker;
  session.is_patient_confirmed = request.is_patient_confirmed;
}

void treat(const SessionVerb& session, const std::filesystem::path& output, Context& context) {
  const auto outcome = runSession(session, context);
  casefile::writePoses(casefile::readPoses(outcome.session / "poses.csv"), output);
  copySecondTable(outcome.session / "poses.csv", output);
  if (session.is_json || (!context.is_quiet && !session.has_commands)) printSession(outcome, session.is_json);
  requireWholeSession(outcome);
}

void track(const steps::TrackRequest& request, const std::filesystem::path& output, bool is_json,
           Context& context) {
  const auto outcome = steps::trackRecording(context.registrations, request, context.monitor);
  casefile::writePoses(outcome.poses, output);
  if (request.second_coil_file)
    casefile::writePoses(outcome.second_poses, casefile::secondCoilPath(output), outcome.second_coil);
  if (is_json)
    return printJson({{"frames", outcome.frames},
                      {"head_tracked", outcome.head_tracked},
                      {"coil_tracked", outcome.coil_tracked},
                      {"second_coil_tracked", outcome.second_tracked},
                      {"processing_ms_median", outcome.processing_ms_median},
                      {"processing_ms_p99", outcome.processing_ms_p99},
                      {"right_late_ms", outcome.right_late_ms},
                      {"readout_ms", outcome.readout_ms}});
  if (context.is_quiet) return;
  std::printf("%d frames: head tracked in %d, coil in %d; %.1f ms a frame (median), %.1f ms (p99)\n",
              outcome.frames, outcome.head_tracked, outcome.coil_tracked, outcome.processing_ms_median,
              outcome.processing_ms_p99);
  if (request.second_coil_file)
    std::printf("second coil '%s' tracked in %d frames\n", outcome.second_coil.c_str(),
                outcome.second_tracked);
  if (outcome.right_late_ms != 0)
    std::printf("the right camera exposes %.1f ms %s the left one: allowed for; better a trigger for both\n",
                std::abs(outcome.right_late_ms), outcome.right_late_ms > 0 ? "after" : "before");
  if (outcome.readout_ms != std::array<double, 2>{0, 0})
    std::printf(
        "rolling shutter: the left camera reads a picture in %.1f ms, the right one in %.1f ms: allowed for "
        "in "
        "the coil's pose\n",
        outcome.readout_ms[0], outcome.readout_ms[1]);
}

void addPlaying(CLI::App& verb, SessionVerb& session) {
  verb.add_option("--speed", session.speed, "with --pulses: plays slower or faster than it was")
      ->check(CLI::Range(0.05, 20.0))
      ->capture_default_str();
  verb.add_option(
          "--passes", session.passes,
          "with --pulses: plays so often, forwards and backwards in turn (a rehearsal); 0: without end")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
}

void run(steps::TrackRequest request, SessionVerb session, const std::filesystem::path& output,
         Context& context) {
  const bool is_live = !session.live.rig.empty(), is_without = session.isWithoutCameras();
  if (is_live + is_without + !request.recording.empty() != 1)
    throw WrongUsage(is_live + is_without > 0
                         ? "more than one of a recording, --live and --tracker-head is given"
                         : "it is not said what to track",
                     "give a RECORDING, or --live RIG");
  fillSession(request, session);
  if (is_live || is_without || !session.sources.empty()) return treat(session, output, context);
  const auto library = coil_library::coilLibrary(session.coil.library);
  if (!session.coil.words.empty()) request.coil_file = coil_library::coilFileOf(session.coil.words, library);
  request.second_coil_file = secondCoilFile(session.coil);
  track(request, output, session.is_json, context);
}

}  // namespace

void addTrack(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("track", "recording or live cameras -> poses of head and coil, frame by frame");
  auto request = std::make_shared<steps::TrackRequest>();
  auto output = std::make_shared<std::filesystem::path>();
  request->aligner = context.registrations.aligners.defaultName();
  request->head_tracker = context.registrations.head_trackers.defaultName();
  request->coil_tracker = context.registrations.coil_trackers.defaultName();
  auto session = std::make_shared<SessionVerb>();
  verb->add_option("RECORDING", request->recording, "recording folder; or --live");
  addLiveSessionOptions(*verb, *session);
  verb->add_option("--case", request->case_folder,
                   "case folder: poses in the MRI's frame, aligned from the recording's capture/");
  addCoilsOption(*verb, session->coil,
                 "the coil: its name in the library, or its coil.json (without it: one 60 mm marker, 4x4_50, "
                 "id 7)");
  verb->add_flag("--keep-looks", request->keeps_key_frames,
                 "keep with the case how the face looked, so that it is found at once in the next session");
  verb->add_option("-o,--output", *output, "poses.csv to write")->required();
  verb->add_option("--head-tracker", request->head_tracker,
                   "method: " + steps::namesOf(context.registrations.head_trackers))
      ->check(namedIn(context.registrations.head_trackers))
      ->capture_default_str();
  verb->add_option("--coil-tracker", request->coil_tracker,
                   "method: " + steps::namesOf(context.registrations.coil_trackers))
      ->check(namedIn(context.registrations.coil_trackers))
      ->capture_default_str();
  addConfirmationOption(*verb, request->is_patient_confirmed);
  verb->add_option("--aligner", request->aligner, "method: " + steps::namesOf(context.registrations.aligners))
      ->check(namedIn(context.registrations.aligners))
      ->capture_default_str();
  addSessionOptions(*verb, *session);
  verb->add_option("--target", session->target, "of a session: the target; default: the case's first one");
  addPlaying(*verb, *session);
  verb->add_flag("--json", session->is_json, "the result as JSON");
  verb->callback([&context, request, output, session, verb] {
    refuseIdleSession(*verb, {"--pulses", "--live", "--tracker-head"});
    refuseIdle(*verb, {"--speed", "--passes", "--target"}, {"--pulses", "--live", "--tracker-head"});
    run(*request, *session, *output, context);
  });
}

}  // namespace facenav::app
