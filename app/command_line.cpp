#include "command_line.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <new>
#include <regex>

#include "facenav/core/data_folder.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/shown_address.h"
#include "facenav/core/standard_output.h"
#include "help_format.h"
#include "settings_flags.h"
#include "software_commit.h"
#include "terminal_progress.h"
#include "typed_values.h"
#include "verb_words.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

std::atomic<bool> g_is_interrupted{false};  // the signal handler may only set this flag

void onInterrupt(int) { g_is_interrupted = true; }

/// Adds the flags to the verb and to those below it.
void addSettingsFlagsBelow(CLI::App& verb, SettingsRequest& request) {
  addSettingsFlags(verb, request);
  for (CLI::App* below : verb.get_subcommands({})) addSettingsFlags(*below, request);
}

void addVerbs(const VerbGroup& group, CLI::App& cli, Context& context) {
  for (const auto add : group.verbs) {
    const auto before = cli.get_subcommands({}).size();
    add(cli, context);
    const auto verbs = cli.get_subcommands({});
    for (std::size_t i = before; i < verbs.size(); ++i) verbs[i]->group(group.step);
  }
}

/// "0.000000 to 20.000000", as CLI11 writes a range, in plain numbers.
std::string inPlainNumbers(const std::string& words) {
  static const std::regex kZeros("(\\d\\.\\d*?)0+(?= |$)"), kPoint("(\\d)\\.(?= |$)");
  return words.find(" not in range ") == std::string::npos
             ? words
             : std::regex_replace(std::regex_replace(words, kZeros, "$1"), kPoint, "$1");
}

int wrongUsage(const std::string& what, const std::string& verb) {
  std::fprintf(stderr, "facenav: %s (see 'facenav%s --help')\n", shownAddress(inPlainNumbers(what)).c_str(),
               verb.empty() ? "" : (" " + verb).c_str());
  return 2;
}

void putSettingsInForce(const Context& context) {
  SettingsRequest typed = context.settings;
  typed.file.reset();
  requireUnderstood([&] { settingsFor(typed); });
  useSettings(context.settings);
  if (context.is_quiet) return;
  for (const std::string& setting : changedSettingsInWords())
    std::fprintf(stderr, "changed setting: %s\n", setting.c_str());
}

void addAll(const Program& program, CLI::App& cli, Context& context) {
  cli.set_version_flag("--version", versionInWords());
  cli.require_subcommand(0, 1);
  cli.formatter(std::make_shared<HelpFormat>());
  for (const VerbGroup& group : program.groups) addVerbs(group, cli, context);
  addHelp(cli, context);
  cli.footer(
      "'facenav help VERB' explains a verb. Without a verb the window starts.\n"
      "The manual has a page for each task: resources/doc/README.md");
  for (const std::string& verb : program.verbs_with_settings)
    addSettingsFlagsBelow(*cli.get_subcommand(verb), context.settings);
  cli.parse_complete_callback([&context] { putSettingsInForce(context); });  // before the verb runs
  for (CLI::App* verb : cli.get_subcommands({})) verb->add_flag("-q,--quiet", "no progress, no notes");
  checkTypedValues(cli);
}

int run(const Program& program, int argc, char** argv) {
  bool is_quiet = false;
  for (int i = 1; i < argc; ++i)
    is_quiet |= std::string(argv[i]) == "--quiet" || std::string(argv[i]) == "-q";
  TerminalProgress progress(is_quiet);
  TaskMonitor monitor([&](const std::string& step, double fraction) {
    progress.show(step, fraction);
    if (g_is_interrupted) monitor.cancel();
  });
  setLogQuiet(is_quiet);
  if (asksForStandardOutput({argv + 1, argv + argc})) keepStandardOutputForFiles();
  Context context{makeRegistrations(), monitor, programPath(), is_quiet};
  if (program.add_peers) program.add_peers(context.registrations);
  CLI::App cli("FaceNav: markerless neuronavigation for rTMS", "facenav");
  addAll(program, cli, context);
  if (const auto wrong = wrongVerb(cli, {argv + 1, argv + argc}))
    return wrongUsage(wrong->in_words, wrong->below);
  const std::string verb = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    return wrongUsage(error.what(), verb);
  } catch (const WrongUsage& error) {
    return wrongUsage(error.what(), verb);
  }
  if (!cli.get_subcommands().empty()) return 0;
  std::printf("%s", cli.help().c_str());
  return 0;
}

}  // namespace

int runProgram(const Program& program, int argc, char** argv) {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  try {
    return run(program, argc, argv);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "facenav: not enough memory for this input\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "facenav: %s\n", error.what());
  }
  return 1;
}

}  // namespace facenav::app
