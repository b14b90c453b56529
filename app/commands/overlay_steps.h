#pragma once
// The options of `facenav plan` for overlays: add, change, list, remove.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"

namespace facenav::app {

struct OverlayRequest {
  std::filesystem::path file;
  std::string space, name, unit;
  std::vector<std::string> removed;
  std::optional<double> threshold, full, opacity;
  bool lists = false;
};

void addOverlayOptions(CLI::App& verb, OverlayRequest& request);
/// Applies the options. Returns true if there was something to do.
bool overlaySteps(const OverlayRequest& request, const casefile::CaseStore& store, bool is_json,
                  bool is_quiet);

}  // namespace facenav::app
