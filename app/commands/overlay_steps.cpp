#include "commands/overlay_steps.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "facenav/core/number_text.h"
#include "facenav/plan/overlays.h"

namespace facenav::app {
namespace {

using casefile::OverlayEntry;

std::string valuesInWords(const OverlayEntry& entry) {
  if (entry.kind != casefile::OverlayKind::map) return {};
  const std::string unit = entry.unit.empty() ? "" : " " + entry.unit;
  return formatted(", from +-%.3g to +-%.3g", entry.threshold, entry.full) + unit;
}

void printOverlays(const std::vector<OverlayEntry>& entries, bool is_json) {
  if (is_json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& entry : entries) {
      list.push_back({{"name", entry.name},
                      {"kind", toString(entry.kind)},
                      {"space", toString(entry.space)},
                      {"file", entry.file},
                      {"opacity", entry.opacity}});
      if (entry.kind != casefile::OverlayKind::map) continue;
      list.back()["threshold"] = entry.threshold;
      list.back()["full"] = entry.full;
      list.back()["unit"] = entry.unit;
    }
    return void(std::printf("%s\n", list.dump(1).c_str()));
  }
  if (entries.empty()) std::printf("no overlay\n");
  for (const auto& entry : entries)
    std::printf("%-16s %-7s %-7s opacity %s%s\n", entry.name.c_str(), toString(entry.kind).c_str(),
                toString(entry.space).c_str(), fixed(entry.opacity, 2).c_str(), valuesInWords(entry).c_str());
}

/// Changes the overlay called --overlay-name by the options; used without a file.
void change(const OverlayRequest& request, const casefile::CaseStore& store) {
  for (OverlayEntry entry : casefile::readOverlays(store.folder())) {
    if (entry.name != request.name) continue;
    if (request.threshold) entry.threshold = *request.threshold;
    if (request.full) entry.full = *request.full;
    if (request.opacity) entry.opacity = *request.opacity;
    if (!request.unit.empty()) entry.unit = request.unit;
    return steps::changeOverlay(store, entry);
  }
  throw Error("the case has no overlay '" + request.name + "'", store.folder().string(),
              "--list-overlays shows its names");
}

void add(const OverlayRequest& request, const casefile::CaseStore& store) {
  steps::NewOverlay wanted;
  wanted.file = request.file;
  wanted.name = request.name;
  if (!request.space.empty()) wanted.space = casefile::overlaySpaceFrom(request.space);
  wanted.threshold = request.threshold;
  wanted.full = request.full;
  wanted.opacity = request.opacity.value_or(wanted.opacity);
  OverlayEntry entry = steps::addOverlay(store, wanted);
  if (request.unit.empty()) return;
  entry.unit = request.unit;
  steps::changeOverlay(store, entry);
}

}  // namespace

void addOverlayOptions(CLI::App& verb, OverlayRequest& request) {
  auto* file = verb.add_option("--overlay", request.file,
                               "shows a file over the MRI: NIfTI map or mask, tracts (.trk .tck .trx .vtk), "
                               "surface (.ply .stl .obj .vtk .vtp); the case keeps a copy");
  verb.add_option("--space", request.space, "where the file lives: native (this MRI), mni")
      ->check(CLI::IsMember({"native", "mni"}))
      ->needs(file);
  verb.add_option("--threshold", request.threshold, "of a map: values from here on are shown, of both signs")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--full", request.full, "of a map: its colours end here");
  verb.add_option("--opacity", request.opacity, "of the overlay, 0..1")->check(CLI::Range(0.0, 1.0));
  verb.add_option("--unit", request.unit, "of a map's values: z, t, V/m, ..");
  verb.add_option("--overlay-name", request.name,
                  "name of the new overlay, or of the one that the other options change");
  verb.add_flag("--list-overlays", request.lists, "the overlays of the case");
  verb.add_option("--remove-overlay", request.removed, "removes an overlay by its name")
      ->allow_extra_args(false);
}

bool overlaySteps(const OverlayRequest& request, const casefile::CaseStore& store, bool is_json,
                  bool is_quiet) {
  const bool changes = request.file.empty() && (request.threshold || request.full || request.opacity ||
                                                !request.unit.empty() || !request.name.empty());
  for (const std::string& name : request.removed) steps::removeOverlay(store, name);
  if (!request.file.empty()) add(request, store);
  if (changes) change(request, store);
  const bool has_edited = !request.removed.empty() || !request.file.empty() || changes;
  if (request.lists || (has_edited && !is_quiet))
    printOverlays(casefile::readOverlays(store.folder()), is_json);
  return has_edited || request.lists;
}

}  // namespace facenav::app
