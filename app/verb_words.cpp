#include "verb_words.h"

#include "facenav/core/near_name.h"

namespace facenav::app {
namespace {

std::vector<std::string> namesOf(const std::vector<const CLI::App*>& verbs) {
  std::vector<std::string> names;
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  return names;
}

const CLI::App* find(const CLI::App& app, const std::string& word) {
  for (const CLI::App* verb : verbsBelow(app))
    if (verb->check_name(word)) return verb;
  return nullptr;
}

/// Returns true if only a verb can follow this verb.
bool takesOnlyVerbs(const CLI::App& app) {
  const auto positionals =
      app.get_options([](const CLI::Option* option) { return option->get_positional(); });
  return !verbsBelow(app).empty() && positionals.empty();
}

std::string inWords(const std::string& before, const std::string& word, const CLI::App& app) {
  const auto near = nearName(word, namesOf(verbsBelow(app)));
  return (before.empty() ? "no verb '" : before + " has no verb '") + word + "'" +
         (near ? "; did you mean '" + *near + "'?" : "");
}

}  // namespace

std::vector<const CLI::App*> verbsBelow(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

NamedVerb namedVerb(const CLI::App& program, const std::vector<std::string>& words) {
  NamedVerb named{&program, program.get_name()};
  for (const std::string& word : words) {
    const CLI::App* next = find(*named.verb, word);
    if (!next) break;
    named = {next, named.words + " " + word};
  }
  return named;
}

std::optional<WrongVerb> wrongVerb(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* app = &program;
  std::string before;
  bool is_help = false;
  for (const std::string& word : words) {
    const bool is_option = !word.empty() && word.front() == '-';
    if (is_help && is_option && word != "--all") return std::nullopt;  // its value is no verb
    if (app == &program && is_option) continue;  // options of the program itself take no value
    if (app == &program && word == "help") {     // words after it name a verb
      is_help = true;
      continue;
    }
    if (is_option || !takesOnlyVerbs(*app)) return std::nullopt;
    const CLI::App* next = find(*app, word);
    if (!next) return WrongVerb{inWords(before, word, *app), before};
    app = next;
    before += (before.empty() ? "" : " ") + word;
  }
  return std::nullopt;
}

}  // namespace facenav::app
