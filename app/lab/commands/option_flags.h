#pragma once
// Flags of the command line from an options struct's fields: frames_per_s -> --frames-per-s.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "facenav/core/field.h"

namespace facenav::app {

/// Adds one flag for each visited field, with its range and default.
struct FlagVisitor {
  CLI::App& verb;
  std::string prefix = {};  // before each name: "patient-"

  std::string flag(const Field& field) const {
    std::string name = field.name;
    std::replace(name.begin(), name.end(), '_', '-');
    return "--" + prefix + name;
  }
  template <class Value>
  void operator()(const Field& field, Value& value) {
    verb.add_option(flag(field), value, field.help)
        ->check(CLI::Range(field.minimum, field.maximum))
        ->capture_default_str();
  }
  void operator()(const Field& field, bool& value) {
    verb.add_option(flag(field), value, field.help + " (true, false)")->capture_default_str();
  }
  void operator()(const Field& field, std::string& value) {
    verb.add_option(flag(field), value, field.help)->capture_default_str();
  }
  void operator()(const Field& field, std::uint64_t& value) {
    verb.add_option(flag(field), value, field.help)->capture_default_str();
  }
};

}  // namespace facenav::app
