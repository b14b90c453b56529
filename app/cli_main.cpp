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
#include "facenav/core/software_version.h"
#include "settings_flags.h"
#include "terminal_progress.h"

namespace {

using namespace facenav;

constexpr const char* kVerbsWithSettings[] = {"prepare",  "align",  "track",    "guide",     "cloud",
                                              "evaluate", "demo",   "settings", "threshold", "hotspot",
                                              "pulses",   "report", "coil",     "target",    "rig"};

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
void addSettingsFlagsBelow(CLI::App& verb, app::SettingsRequest& request) {
  app::addSettingsFlags(verb, request);
  for (CLI::App* below : verb.get_subcommands({})) app::addSettingsFlags(*below, request);
}

void useSettings(const app::Context& context) {
  app::useSettings(context.settings);
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
  cli.set_version_flag("--version", softwareVersion());
  cli.require_subcommand(0, 1);
  app::addSeries(cli, context);
  app::addPacs(cli, context);
  app::addPrepare(cli, context);
  app::addCheck(cli, context);
  app::addBrain(cli, context);
  app::addWorklist(cli, context);
  app::addLabel(cli, context);
  app::addCameras(cli, context);
  app::addCalibrate(cli, context);
  app::addRig(cli, context);
  app::addRecord(cli, context);
  app::addProjector(cli, context);
  app::addCalibrateCoil(cli, context);
  app::addAlign(cli, context);
  app::addTrack(cli, context);
  app::addCloud(cli, context);
  app::addGuide(cli, context);
  app::addSessions(cli, context);
  app::addPulses(cli, context);
  app::addReport(cli, context);
  app::addThreshold(cli, context);
  app::addHotspot(cli, context);
  app::addNote(cli, context);
  app::addSimulate(cli, context);
  app::addLocate(cli, context);
  app::addTarget(cli, context);
  app::addPlan(cli, context);
  app::addExport(cli, context);
  app::addFaceCase(cli, context);
  app::addImport(cli, context);
  app::addCoil(cli, context);
  app::addMarker(cli, context);
  app::addEvaluate(cli, context);
  app::addDemo(cli, context);
  app::addSettings(cli, context);
  for (const char* verb : kVerbsWithSettings)
    addSettingsFlagsBelow(*cli.get_subcommand(verb), context.settings);
  cli.parse_complete_callback([&context] { useSettings(context); });  // before the verb runs
  for (CLI::App* verb : cli.get_subcommands({})) verb->add_flag("-q,--quiet", "no progress, no notes");
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    std::fprintf(stderr, "facenav: %s (see 'facenav%s --help')\n", error.what(),
                 argc > 1 && argv[1][0] != '-' ? (" " + std::string(argv[1])).c_str() : "");
    return 2;
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
