#pragma once
// Finds the verb that a command line names, and the error if a word is no verb.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace facenav::app {

/// The verbs directly below the program or a verb.
std::vector<const CLI::App*> verbsBelow(const CLI::App& app);

/// Verb named by the words ("rig", "new"), and the words up to it.
struct NamedVerb {
  const CLI::App* verb;
  std::string words;  // "facenav rig new"
};

/// Follows `words` from verb to verb as far as they name any. Never fails: without a word it returns
/// `program`.
NamedVerb namedVerb(const CLI::App& program, const std::vector<std::string>& words);

/// Word that is no verb, in a position where only a verb is valid.
struct WrongVerb {
  std::string in_words;  // "no verb 'prepar'; did you mean 'prepare'?"
  std::string below;     // verb below which it was searched: "rig"; empty: the program's own
};

/// Returns the first such word, or nothing. `words`: the command line without the program's name.
std::optional<WrongVerb> wrongVerb(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace facenav::app
