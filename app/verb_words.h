#pragma once
// The verbs as words of the command line: which one is meant, and what is wrong with one that is none.

#include <CLI/CLI.hpp>

namespace facenav::app {

/// The verb that `words` lead to ("rig", "new"), and the words up to it.
struct NamedVerb {
  const CLI::App* verb;
  std::string words;  // "facenav rig new"
};

/// Follows `words` from verb to verb as far as they name any. Never fails: without a word it is `program`.
NamedVerb namedVerb(const CLI::App& program, const std::vector<std::string>& words);

/// A word that stands where only a verb can stand, and is none.
struct WrongVerb {
  std::string in_words;  // "no verb 'prepar'; did you mean 'prepare'?"
  std::string below;     // the verb whose verbs were meant: "rig"; empty: the program's own
};

/// The first such word; nothing: there is none. `words`: the command line without the program's name.
std::optional<WrongVerb> wrongVerb(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace facenav::app
