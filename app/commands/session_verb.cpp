#include "commands/session_verb.h"

#include <algorithm>
#include <cstdio>

#include "commands/pulse_keys.h"
#include "commands/session_commands.h"
#include "commands/session_teller.h"
#include "commands/two_coils.h"
#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/links/igtl_client.h"
#include "facenav/treat/live_orders.h"
#include "facenav/treat/served_tracker.h"
#include "facenav/treat/session_return.h"
#include "idle_options.h"
#include "json_output.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

constexpr const char* kKeyboard = "keyboard";

/// Warns of an interrupted session of the case.
void noteInterrupted(const SessionVerb& verb, const Context& context) {
  if (verb.goes_on || context.is_quiet) return;
  if (const auto session = steps::interruptedSession(verb.case_folder))
    std::fprintf(stderr, "note: %s; --continue goes on with it\n",
                 steps::inWords(*session, steps::plannedPulses(verb.case_folder, session->target)).c_str());
}

/// Lets the session open the cameras, and open them again after each interruption.
steps::LiveCameras liveOf(const SessionVerb& verb, const Context& context) {
  LiveChoice choice = verb.live;
  choice.coil = verb.coil;
  steps::LiveCameras live;
  const capture::RigStore store(verb.live.rigs);
  live.rig = store.read(verb.live.rig).rig;
  live.keepLearnt = [store, name = verb.live.rig](const steps::CamerasLearnt& learnt) {
    steps::keepLearnt(store, name, learnt);
  };
  live.seconds = verb.seconds;
  live.open = [choice, &context] { return openLive(choice, context); };
  return live;
}

/// Throws WrongUsage if options of another tracker contradict each other or the rest.
void requireWholeTracker(const SessionVerb& verb) {
  if (!verb.isWithoutCameras()) {
    if (!verb.tracker.empty() && verb.tracker_pose.empty())
      throw WrongUsage("--tracker alone does not say how that tracker stands to the head",
                       "give --tracker-pose with the cameras, or --tracker-head and --tracker-alignment");
    return;
  }
  if (!verb.live.rig.empty() || !verb.recording.empty())
    throw WrongUsage("--tracker-head is for a session without cameras", "leave out --live and the recording");
  if (verb.goes_on) throw WrongUsage("--continue goes on with cameras", "leave it out with --tracker-head");
  if (verb.tracker_second.empty() != verb.coil.second.empty())
    throw WrongUsage("a second coil needs --coil twice and --tracker-second", "give both, or neither");
}

void addTwoCoils(const SessionVerb& verb, steps::TreatRecordingRequest& request) {
  if (verb.coil.second.empty() && !verb.second_target.empty())
    throw WrongUsage("--second-target is for a second coil", "give --coil twice, or leave it out");
  std::vector<std::string> others;  // sources that can name the coil with each pulse
  if (verb.has_commands) others.push_back(kKeyboard);
  if (!verb.outputs.accept.empty()) others.push_back(steps::kOrderSource);
  request.coil_of_source = coilOfSourceFrom(verb.pulse_coils, verb.sources, others, verb.coil);
  request.second_coil_file = secondCoilFile(verb.coil);
  request.second_target = verb.second_target;
}

steps::TreatRecordingRequest requestOf(const SessionVerb& verb, const Context& context) {
  requireWholeTracker(verb);
  steps::TreatRecordingRequest request;
  request.recording = verb.recording;
  request.case_folder = verb.case_folder;
  const auto library = coil_library::coilLibrary(verb.coil.library);
  if (!verb.coil.words.empty()) request.coil_file = coil_library::coilFileOf(verb.coil.words, library);
  request.aligner = verb.aligner;
  request.is_patient_confirmed = verb.is_patient_confirmed;
  request.head_tracker = verb.head_tracker;
  request.coil_tracker = verb.coil_tracker;
  request.target = verb.target;
  for (const auto& source : verb.sources)
    if (source != kKeyboard) request.sources.push_back(source);
  request.intensity_pct = verb.intensity_pct;
  if (!verb.reason.empty()) request.override = {verb.by, verb.reason};
  request.goes_on = verb.goes_on;
  request.session = verb.session;
  request.field_coil = verb.field_coil;
  request.speed = verb.speed;
  request.passes = verb.passes;
  if (!verb.live.rig.empty()) request.live = liveOf(verb, context);
  addTwoCoils(verb, request);
  if (verb.isWithoutCameras())
    request.other_tracker = steps::OtherTracker{verb.tracker, verb.tracker_head, verb.tracker_second,
                                                verb.tracker_alignment, verb.seconds};
  else if (!verb.tracker.empty())
    request.makeCoilTracker = [words = verb.tracker, pose = steps::readTrackerPose(verb.tracker_pose)] {
      return steps::makeServedCoilTracker(words, pose);
    };
  return request;
}

bool hasKeyboard(const SessionVerb& verb) {
  const bool has = std::find(verb.sources.begin(), verb.sources.end(), kKeyboard) != verb.sources.end();
  if (has && verb.has_commands)
    throw WrongUsage("--pulses keyboard and --commands both read standard input",
                     "use the command 'pulse' in place of the keyboard");
  return has;
}

links::LiveIncoming incomingOf(const SessionVerb& verb, steps::LiveOrders& orders) {
  if (verb.outputs.accept.empty()) return {};
  const auto accepted = links::incomingFrom(verb.outputs.accept);
  return orders.incoming(accepted.takes_commands, accepted.takes_targets);
}

/// Prints what clients of the server sent; for another program as JSON on standard output.
void tellOrders(const std::vector<steps::OrderNews>& news, bool is_json) {
  for (const auto& each : news) {
    if (is_json)
      printJsonLine({{"order", each.words}, {"offered", each.offered}});
    else
      std::fprintf(stderr, "%s\n", each.words.c_str());
  }
}

}  // namespace

void addLiveSessionOptions(CLI::App& verb, SessionVerb& session) {
  auto* live = verb.add_option("--live", session.live.rig,
                               "live cameras: a rig by its name, see 'facenav rig list'; the case is aligned "
                               "before, by 'facenav align CASE --live RIG'");
  verb.add_option("--rigs", session.live.rigs, "with --live: folder of the rigs")->needs(live);
  verb.add_option("--seconds", session.seconds,
                  "with --live or --tracker-head: how long; default: until Ctrl-C")
      ->check(CLI::Range(0.1, 86400.0));
}

void addSessionOptions(CLI::App& verb, SessionVerb& session) {
  verb.add_option("--pulses", session.sources,
                  "logs a session in the case, with the pulses of this source: " + links::pulseSourceWords() +
                      ", keyboard (Return, space or p on the terminal; q ends); a recording is played as if "
                      "live; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--intensity", session.intensity_pct,
                  "with --pulses: % of the maximal output, where the source does not know it")
      ->check(CLI::Range(0.0, 100.0));
  verb.add_option("--field-coil", session.field_coil,
                  "with --pulses: coil whose electric field is kept with each pulse: figure8-70, round, or a "
                  ".ccd, .tcd, .nii.gz file")
      ->capture_default_str();
  auto* by = verb.add_option("--by", session.by, "who overrides a missing sign-off");
  verb.add_option("--override", session.reason, "treats a case without a sign-off; why")->needs(by);
  auto* goes_on = verb.add_flag("--continue", session.goes_on,
                                "goes on with the case's newest session, on the case's own alignment, which "
                                "is checked first; pulses are counted on");
  verb.add_option("--session", session.session, "with --continue: another session, or how its name begins")
      ->needs(goes_on);
  verb.add_flag("--commands", session.has_commands,
                "takes commands on standard input, and tells each pulse that is on the disk as a line of "
                "JSON: " +
                    sessionCommandWords());
  auto* tracker = verb.add_option("--tracker", session.tracker,
                                  "the coil's pose from another tracker, by OpenIGTLink: "
                                  "igtl://HOST[:PORT]/NAME; it is not synchronised with the cameras");
  auto* tracker_pose =
      verb.add_option("--tracker-pose", session.tracker_pose,
                      "JSON file with camera_T_tracker: how that tracker stands to the left camera");
  tracker->check(understoodBy(links::servedPoseFrom));
  tracker_pose->needs(tracker);
  auto* head =
      verb.add_option("--tracker-head", session.tracker_head,
                      "name of the head's pose at that tracker (SubjectToTracker): a session without "
                      "cameras");
  auto* alignment =
      verb.add_option("--tracker-alignment", session.tracker_alignment,
                      "JSON file: how the tool on the head stands to the MRI (mri_T_subject, or "
                      "points touched on the head) and its error");
  auto* second = verb.add_option("--tracker-second", session.tracker_second,
                                 "name of the second coil's pose at that tracker");
  head->needs(tracker)->needs(alignment)->excludes(tracker_pose);
  alignment->needs(head);
  second->needs(head);
  addSecondTargetOption(verb, session.second_target);
  verb.add_option(
          "--pulse-coil", session.pulse_coils,
          "with two coils: the coil that gives the pulses, by its name, or SOURCE=COIL for each source "
          "of --pulses (keyboard too); may be repeated")
      ->allow_extra_args(false);
  addOutputOptions(verb, session.outputs);
}

void refuseIdleSession(const CLI::App& verb, const std::vector<std::string>& starters) {
  std::vector<std::string> options{"--intensity", "--field-coil", "--by",      "--override",
                                   "--continue",  "--commands",   "--tracker", "--pulse-coil",
                                   "--serve",     "--address",    "--send",    "--accept"};
  const bool starts_by_pulses = std::find(starters.begin(), starters.end(), "--pulses") != starters.end();
  if (!starts_by_pulses) options.push_back("--pulses");
  refuseIdle(verb, options, starters);
  refuseIdle(verb, {"--seconds"}, {"--live", "--tracker-head"});
}

steps::TreatRecordingOutcome runSession(const SessionVerb& verb, Context& context) {
  if (verb.case_folder.empty())
    throw WrongUsage("a session belongs to a case",
                     verb.live.rig.empty()
                         ? "give it with --case"
                         : "give it with --case (without a case: facenav record, then track)");
  steps::LiveOrders orders;  // outlives the outputs in the request
  auto request = requestOf(verb, context);
  const bool has_keyboard = hasKeyboard(verb);
  noteInterrupted(verb, context);
  if (verb.live.rig.empty() && !verb.isWithoutCameras())
    capture::openRecording(verb.recording);  // missing: said before a port opens
  request.outputs = openOutputs(verb.outputs, context.is_quiet, incomingOf(verb, orders));
  SessionCommands commands(coil_library::coilLibrary(verb.coil.library), verb.case_folder, orders);
  SessionTeller teller(context.is_quiet || verb.has_commands || verb.is_json);
  std::optional<PulseKeys> keys;
  if (has_keyboard) keys.emplace(context.is_quiet);
  const auto store = casefile::CaseStore::open(verb.case_folder);
  request.look = [&](steps::Treatment& treatment) {
    teller.look(treatment);
    if (!verb.outputs.accept.empty()) tellOrders(orders.obey(treatment, store), verb.has_commands);
    if (keys && !keys->look(treatment)) return false;
    return !verb.has_commands || commands.look(treatment);
  };
  return steps::treatRecording(context.registrations, request, context.monitor);
}

void printSession(const steps::TreatRecordingOutcome& outcome, bool is_json) {
  const auto& pulses = outcome.pulses;
  if (is_json)
    return printJson({{"session", outcome.session.filename().string()},
                      {"on_target", pulses.on_target},
                      {"outside", pulses.outside},
                      {"lost", pulses.lost},
                      {"frames", outcome.frames},
                      {"processing_ms_median", outcome.processing_ms_median},
                      {"processing_ms_p99", outcome.processing_ms_p99},
                      {"failure", outcome.failure}});
  std::printf("session %s: %d pulses on target, %d outside, %d with head or coil lost\n",
              outcome.session.filename().c_str(), pulses.on_target, pulses.outside, pulses.lost);
  std::printf("%d frames; %.1f ms a frame (median), %.1f ms (p99)\n", outcome.frames,
              outcome.processing_ms_median, outcome.processing_ms_p99);
}

void copySecondTable(const std::filesystem::path& table, const std::filesystem::path& output) {
  const auto second = casefile::secondCoilPath(table);
  if (std::filesystem::exists(second))
    writeWholeFile(casefile::secondCoilPath(output), readWholeFile(second), FileAccess::owner_only);
}

void requireWholeSession(const steps::TreatRecordingOutcome& outcome) {
  if (!outcome.failure.empty())
    throw Error(outcome.failure + "; the session is kept", outcome.session.filename().string());
}

}  // namespace facenav::app
