#pragma once
// Checks what is typed behind every option of every verb, in one place: numbers are finite and of usable
// size, texts hold no control characters and are not endless. Checks of single options come on top.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "facenav/core/registry.h"

namespace facenav::app {

/// Check of an option whose words `read` must understand; what it throws is wrong usage.
CLI::Validator understoodBy(std::function<void(const std::string&)> read);
/// Check of an option that names a method of the registry, which must outlive the check.
template <class Interface>
CLI::Validator namedIn(const Registry<Interface>& registry) {
  return understoodBy([&registry](const std::string& name) { registry.create(name); });
}

/// Check of an option that names a folder to make: refuses "-", standard output.
CLI::Validator folderToMake();

/// Check of an option that names a file to write: its name ends so ("a report"), or it is standard output.
CLI::Validator namedLike(const std::vector<std::string>& endings, const std::string& what);

/// Returns true if `-o -` is among the words, or another file to write as "-": it goes to standard output.
bool asksForStandardOutput(const std::vector<std::string>& words);

/// Adds the checks to the options of `program` and of all verbs below it. Call it when all verbs are there.
void checkTypedValues(CLI::App& program);

}  // namespace facenav::app
