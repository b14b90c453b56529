// The command line: parses, runs one verb, turns exceptions into one line and an exit status
// (0 done, 1 could not be done, 2 wrong usage). Without a verb it starts the window.

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <new>

#include "commands/commands.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/workflow/software_version.h"
#include "help_format.h"
#include "settings_flags.h"
#include "software_commit.h"
#include "terminal_progress.h"
#include "verb_words.h"

namespace {

using namespace facenav;

constexpr const char* kVerbsWithSettings[] = {"prepare",  "align",  "track",    "guide",     "cloud",
                                              "evaluate", "demo",   "settings", "threshold", "hotspot",
                                              "pulses",   "report", "coil",     "target",    "rig"};

/// The verbs of one step of the clinic's path. --help lists them together.
struct VerbGroup {
  const char* step;
  std::vector<void (*)(CLI::App&, app::Context&)> verbs;
};

const VerbGroup kVerbGroups[] = {
    {"Prepare",
     {app::addPacs, app::addSeries, app::addPrepare, app::addCheck, app::addBrain, app::addWorklist,
      app::addLabel, app::addExport}},
    {"Plan", {app::addLocate, app::addTarget, app::addPlan}},
    {"Set up",
     {app::addCameras, app::addCalibrate, app::addRig, app::addRecord, app::addProjector, app::addMarker,
      app::addCalibrateCoil, app::addCoil}},
    {"Align", {app::addAlign, app::addCloud}},
    {"Treat", {app::addTrack, app::addGuide, app::addThreshold}},
    {"Review", {app::addSessions, app::addPulses, app::addHotspot, app::addNote, app::addReport}},
    {"Home", {app::addFaceCase, app::addImport}},
    {"Lab and others", {app::addSimulate, app::addEvaluate, app::addDemo, app::addSettings}},
};

std::atomic<bool> g_is_interrupted{false};  // the signal handler may only set this flag

void onInterrupt(int) { g_is_interrupted = true; }

std::filesystem::path programPath() {
  std::error_code error;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path("facenav") : path;
}

int startWindow(const std::filesystem::path& program) {
  const auto window = program.parent_path() / "facenav-gui";
  ::execl(window.c_str(), window.c_str(), nullptr);
  std::fprintf(
      stderr,
      "facenav: the window is not installed beside this program (%s); 'facenav --help' lists the verbs\n",
      window.c_str());
  return 1;
}

/// To the verb and to those below it.
void addSettingsFlags(CLI::App& verb, workflow::SettingsRequest& request) {
  app::addSettingsFlags(verb, request);
  for (CLI::App* below : verb.get_subcommands({})) app::addSettingsFlags(*below, request);
}

void addVerbs(const VerbGroup& group, CLI::App& cli, app::Context& context) {
  for (const auto add : group.verbs) {
    const auto before = cli.get_subcommands({}).size();
    add(cli, context);
    const auto verbs = cli.get_subcommands({});
    for (std::size_t i = before; i < verbs.size(); ++i) verbs[i]->group(group.step);
  }
}

std::string versionInWords() {
  return workflow::softwareVersion() + " (commit " + app::softwareCommit() + ")";
}

int wrongUsage(const std::string& what, const std::string& verb) {
  std::fprintf(stderr, "facenav: %s (see 'facenav%s --help')\n", what.c_str(),
               verb.empty() ? "" : (" " + verb).c_str());
  return 2;
}

void useSettings(const app::Context& context) {
  workflow::useSettings(context.settings);
  if (context.is_quiet) return;
  for (const std::string& setting : changedSettingsInWords())
    std::fprintf(stderr, "changed setting: %s\n", setting.c_str());
}

int runCommandLine(int argc, char** argv) {
  bool is_quiet = false;
  for (int i = 1; i < argc; ++i)
    is_quiet |= std::string(argv[i]) == "--quiet" || std::string(argv[i]) == "-q";
  app::TerminalProgress progress(is_quiet);
  TaskMonitor monitor([&](const std::string& step, double fraction) {
    progress.show(step, fraction);
    if (g_is_interrupted) monitor.cancel();
  });
  setLogQuiet(is_quiet);

  app::Context context{app::makeRegistrations(), monitor, programPath(), is_quiet};
  CLI::App cli("FaceNav: markerless neuronavigation for rTMS", "facenav");
  cli.set_version_flag("--version", versionInWords());
  cli.require_subcommand(0, 1);
  cli.formatter(std::make_shared<app::HelpFormat>());
  for (const VerbGroup& group : kVerbGroups) addVerbs(group, cli, context);
  app::addHelp(cli, context);
  cli.footer(
      "'facenav help VERB' explains a verb. Without a verb the window starts.\n"
      "The manual has a page for each task: resources/doc/README.md");
  for (const char* verb : kVerbsWithSettings) addSettingsFlags(*cli.get_subcommand(verb), context.settings);
  cli.parse_complete_callback([&context] { useSettings(context); });  // before the verb runs
  for (CLI::App* verb : cli.get_subcommands({})) verb->add_flag("-q,--quiet", "no progress, no notes");
  if (const auto wrong = app::wrongVerb(cli, {argv + 1, argv + argc}))
    return wrongUsage(wrong->in_words, wrong->below);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    return wrongUsage(error.what(), argc > 1 && argv[1][0] != '-' ? argv[1] : "");
  }
  if (cli.get_subcommands().empty()) return startWindow(context.program);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  try {
    return runCommandLine(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "facenav: not enough memory for this input\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "facenav: %s\n", error.what());
  }
  return 1;
}
