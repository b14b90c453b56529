// facenav help [VERB ..]: the same as `facenav VERB --help`; facenav help --all: every verb; --completion and
// --man-pages: the same description for a shell and for man.

#include <cstdio>

#include "command_line.h"
#include "commands/commands.h"
#include "completion.h"
#include "facenav/core/data_folder.h"
#include "lab_program.h"
#include "man_page.h"
#include "typed_values.h"
#include "verb_words.h"

namespace facenav::app {
namespace {

struct HelpRequest {
  std::vector<std::string> words;
  bool is_all = false;
  std::string shell;
  std::filesystem::path man_pages;
};

void printHelp(const CLI::App& program, const NamedVerb& named) {
  const auto text = program.get_formatter()->make_help(named.verb, named.words, CLI::AppFormatMode::Normal);
  std::printf("%s", text.c_str());
}

/// Prints the help of the verb, then of those below it.
void printAll(const CLI::App& program, const NamedVerb& named) {
  std::printf("-- %s\n", named.words.c_str());
  printHelp(program, named);
  for (const CLI::App* below : named.verb->get_subcommands([](const CLI::App*) { return true; }))
    printAll(program, {below, named.words + " " + below->get_name()});
}

}  // namespace

void addHelp(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("help", "explains a verb, as 'facenav VERB --help' does");
  verb->group("");  // the last lines of --help mention it
  auto request = std::make_shared<HelpRequest>();
  verb->add_option("VERB", request->words,
                   "a verb, and the one below it: 'facenav help rig new'; without one: the list of verbs");
  verb->add_flag("--all", request->is_all, "this verb and all below it, or all verbs");
  verb->add_option("--completion", request->shell,
                   "prints the completion for a shell: source <(facenav help --completion bash)")
      ->check(CLI::IsMember({"bash", "zsh"}));
  verb->add_option("--man-pages", request->man_pages, "writes man pages into this folder (man1 of a manpath)")
      ->check(folderToMake());
  verb->callback([&app, &context, request] {
    if (!request->shell.empty())
      return void(
          std::fputs((request->shell == "zsh" ? zshCompletion(app) : bashCompletion(app)).c_str(), stdout));
    if (!request->man_pages.empty()) {
      const int pages = writeManPages(app, request->man_pages);
      if (!context.is_quiet) std::printf("%d pages in %s\n", pages, request->man_pages.c_str());
      return;
    }
    const auto named = namedVerb(app, request->words);
    if (!request->is_all) return printHelp(app, named);
    printAll(app, named);
    const bool is_lab = programPath().filename() == "facenav-lab";
    if (named.verb == &app && !is_lab) printHelpOfLab();
  });
}

}  // namespace facenav::app
