// facenav evaluate [--scenario ..] [--head ..] -o DIR: compares the live path with the accuracy goals, over
// scenarios, seeds, heads and rigs of the virtual room, or over recordings with truth.

#include <cstdio>
#include <set>

#include "commands/lab_commands.h"
#include "commands/option_flags.h"
#include "evaluate/evaluation_head.h"
#include "evaluate/evaluation_plan.h"
#include "evaluate/evaluation_run.h"
#include "evaluate/plain_align_run.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/software_version.h"
#include "facenav/evaluation/evaluation_report.h"
#include "facenav/guidance/hand_knob.h"
#include "result_folder.h"
#include "settings.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

namespace fs = std::filesystem;

struct EvaluateRequest {
  EvaluationRequest room;
  std::vector<fs::path> recordings;
  std::optional<fs::path> case_folder;
  std::string target;
  Methods methods;
  bool is_right_only = false;  // plain_align: only what must succeed, no faults
  fs::path output = "facenav_evaluation";
};

std::string nameOf(const evaluation::RunRecord& run) {
  return run.scenario + ", " + run.head + ", seed " + std::to_string(run.seed);
}

void playHead(Context& context, const EvaluateRequest& request, const EvaluationHead& head,
              const surface::ScalpSurface* other, double done, double share,
              std::vector<evaluation::RunRecord>& runs) {
  const auto planned = plannedRuns(request.room);
  std::optional<AlignedCapture> last;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    evaluation::RunRecord run;
    run.scenario = planned[i].options.name;
    run.head = head.name;
    run.rig = planned[i].rig;
    run.seed = planned[i].options.seed;
    run.is_scan_cut = head.is_scan_cut;
    run.is_unseen_head = head.is_unseen;
    const auto report = [&](double part) {
      context.monitor.report("evaluate: " + nameOf(run),
                             done + share * (double(i) + part) / double(planned.size()));
    };
    report(0.0);
    if (run.scenario == room::kPlainAlign) {
      const auto tries = request.is_right_only ? AlignTries::right : AlignTries::all;
      for (auto& one : runPlainAlign(context, planned[i].options, head, other, request.methods, run, tries))
        runs.push_back(std::move(one));
      continue;
    }
    auto sequence = roomSequence(planned[i].options, head);
    runSequence(context, sequence, head.scalp, head.target, request.methods, last, run, report);
    if (run.scenario == "capture")
      run.frames.clear();  // a recording needs a frame, but a capture is not
                           // evaluated on it
    runs.push_back(std::move(run));
  }
}

std::vector<evaluation::RunRecord> playRoom(Context& context, const EvaluateRequest& request) {
  std::vector<evaluation::RunRecord> runs;
  const double share = 1.0 / double(request.room.heads.size());
  std::optional<EvaluationHead> before;
  for (std::size_t i = 0; i < request.room.heads.size(); ++i) {
    auto head = makeEvaluationHead(context, request.room.heads[i]);
    playHead(context, request, head, before ? &before->scalp : nullptr, double(i) * share, share, runs);
    before = std::move(head);
  }
  return runs;
}

/// The target at which errors are measured: the case's, or without a plan a first guess of the hand area.
guidance::Target measuredAt(const casefile::CaseStore& store, const std::string& name) {
  const auto plan = store.targets();
  if (!name.empty()) return plan.find(name);
  if (!plan.targets.empty()) return plan.targets.front();
  const auto brain = store.brain();
  if (!brain)
    throw Error("case has neither a target nor a brain to measure at", store.folder().string(),
                "plan a target first");
  guidance::Target target;
  target.name = "left hand area";
  target.cortex_point = guidance::handKnobGuess(*brain, guidance::Side::left);
  return target;
}

std::vector<evaluation::RunRecord> playRecordings(Context& context, const EvaluateRequest& request) {
  const auto store = casefile::CaseStore::open(request.case_folder.value());
  const auto target = measuredAt(store, request.target);
  const auto scalp = store.scalp();
  std::vector<evaluation::RunRecord> runs;
  for (const auto& folder : request.recordings) {
    auto sequence = recordedSequence(folder);
    std::optional<AlignedCapture> none;
    evaluation::RunRecord run;
    run.scenario = sequence.scenario;
    run.head = store.folder().filename().string();
    run.rig = "of the recording";
    run.is_unseen_head = true;
    const double done = double(runs.size());
    runSequence(context, sequence, scalp, target, request.methods, none, run, [&](double part) {
      context.monitor.report("evaluate: " + run.scenario, (done + part) / double(request.recordings.size()));
    });
    runs.push_back(std::move(run));
  }
  return runs;
}

/// " Measured with changed settings: ..", if any differ.
std::string measuredWith() {
  const auto changed = changedSettingsFinding(" Measured");
  return changed ? *changed + "." : "";
}

void runEvaluate(Context& context, const EvaluateRequest& request) {
  ResultFolder result(request.output, "evaluation.csv", "an evaluation");
  const bool is_recorded = !request.recordings.empty();
  const auto runs = is_recorded ? playRecordings(context, request) : playRoom(context, request);
  const std::string about =
      (is_recorded ? std::to_string(runs.size()) + " recordings with truth." : inWords(request.room)) +
      " Aligner " + request.methods.aligner + ", head tracker " + request.methods.head_tracker +
      ", coil tracker " + request.methods.coil_tracker + "; FaceNav " + softwareVersion() + "." +
      measuredWith();
  evaluation::writeEvaluation(runs, about, result.path());
  result.finish();
  if (context.is_quiet) return;
  std::printf("%s\n\n%s\nwritten: %s\n", about.c_str(), evaluation::goalsMarkdown(runs).c_str(),
              (fs::absolute(request.output) / "report.html").c_str());
}

/// Flags for the options of the room that all runs share; the plan sets the others.
struct SharedFlags {
  CLI::App& verb;
  template <class Value>
  void operator()(const Field& field, Value& value) {
    static const std::set<std::string> shared{"noise_grey",      "gamma",
                                              "blur_px",         "exposure",
                                              "frames_per_s",    "head_distance_mm",
                                              "jpeg_quality",    "gloss",
                                              "haze_grey",       "right_gain",
                                              "right_gamma",     "blinks",
                                              "hair_sway_mm",    "skin_contrast",
                                              "bayer",           "grey_red",
                                              "grey_blue",       "right_grey_red",
                                              "right_grey_blue", "rig",
                                              "drift_deg",       "drift_mm",
                                              "drift_about",     "rolling_ms",
                                              "exposure_ms",     "exposure_step",
                                              "refocus_px",      "clock_ppm",
                                              "dropped",         "doubled",
                                              "right_late_ms",   "right_time_stamps",
                                              "stated_row_time"};
    if (shared.count(field.name)) FlagVisitor{verb}(field, value);
  }
};

void addPlan(CLI::App& verb, EvaluateRequest& request) {
  EvaluationRequest& room = request.room;
  std::string scenarios = "scenarios of the virtual room (default: all): capture";
  for (const auto& kind : room::scenarios())
    if (kind.name != "capture") scenarios += ", " + kind.name;
  verb.add_option("--scenario", room.scenarios, scenarios)->delimiter(',');
  verb.add_option("--seeds", room.seeds, "seeds of each scenario")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb.add_option("--first-seed", room.first_seed, "the first of them")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  verb.add_option("--head,--case", room.heads,
                  "heads: patient, colin27, a NIfTI file or a case folder, then variants after colons "
                  "(patient:child:lip): " +
                      headVariants())
      ->delimiter(',')
      ->capture_default_str();
  verb.add_option("--rigs", room.rigs, "camera rigs: the room's own, then random ones")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb.add_option("--captures", room.captures,
                  "alignments alone, the patient seated up to 30 deg and 60 mm off")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  verb.add_option("--frames", room.frames, "of each scenario (0: its own length)")
      ->check(CLI::Range(0, 100000));
  verb.add_flag("--quick", room.is_quick, "one seed, few frames, five captures");
  verb.add_flag("--right-only", request.is_right_only,
                "plain_align: only what must be aligned, no turned cameras and nothing to be refused");
  room::ScenarioOptions::visit(room.room, SharedFlags{verb});
}

void addMethods(CLI::App& verb, EvaluateRequest& request, const Context& context) {
  verb.add_option("--aligner", request.methods.aligner,
                  "method: " + steps::namesOf(context.registrations.aligners))
      ->check(namedIn(context.registrations.aligners))
      ->capture_default_str();
  verb.add_option("--head-tracker", request.methods.head_tracker,
                  "method: " + steps::namesOf(context.registrations.head_trackers))
      ->check(namedIn(context.registrations.head_trackers))
      ->capture_default_str();
  verb.add_option("--coil-tracker", request.methods.coil_tracker,
                  "method: " + steps::namesOf(context.registrations.coil_trackers))
      ->check(namedIn(context.registrations.coil_trackers))
      ->capture_default_str();
}

/// Runs the request: in the virtual room, or in the recordings of one case.
void runRequested(Context& context, EvaluateRequest& request) {
  if (!request.recordings.empty()) {
    if (request.room.heads.size() != 1 || request.room.heads.front() == "patient")
      throw WrongUsage("a recording is measured in one case", "add --case CASE");
    request.case_folder = request.room.heads.front();
    for (const auto& folder : request.recordings) recordedSequence(folder);  // each can be opened
  } else {
    requireUnderstood([&] {
      plannedRuns(request.room);
      for (const auto& head : request.room.heads) requireKnownHead(head);
    });
  }
  runEvaluate(context, request);
}

}  // namespace

void addEvaluate(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "evaluate", "the live path against the accuracy goals, over scenarios, seeds, heads, rigs");
  auto request = std::make_shared<EvaluateRequest>();
  request->methods = {context.registrations.aligners.defaultName(),
                      context.registrations.head_trackers.defaultName(),
                      context.registrations.coil_trackers.defaultName()};
  addPlan(*verb, *request);
  verb->add_option("--recording", request->recordings,
                   "recordings with truth/ instead of the virtual room (with one --case)");
  verb->add_option("--target", request->target,
                   "target of the case to measure at, with --recording (default: the first)");
  addMethods(*verb, *request, context);
  verb->add_option("-o,--output", request->output, "folder for report.html, evaluation.csv, evaluation.md")
      ->check(folderToMake())
      ->capture_default_str();
  addEvaluatePrepare(*verb, context);
  addEvaluateRigs(*verb, context);
  addEvaluateSkin(*verb, context);
  addEvaluatePairs(*verb, context);
  addEvaluateReturn(*verb, context);
  addEvaluateGates(*verb, context);
  verb->callback([&context, request, verb] {
    if (!verb->get_subcommands().empty()) return;
    runRequested(context, *request);
  });
}

}  // namespace facenav::app
