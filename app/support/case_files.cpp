#include "support/case_files.h"

#include <regex>
#include <set>

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// Names of resources/doc/formats.md.
const std::set<std::string> kKnown{"case.json",
                                   "mri.nii.gz",
                                   "head_mask.nii.gz",
                                   "brain_mask.nii.gz",
                                   "scalp.vtp",
                                   "brain.vtp",
                                   "brain_texture.png",
                                   "targets.json",
                                   "targets_damaged.json",
                                   "alignment.json",
                                   "rejection.json",
                                   "sign_off.json",
                                   "navigation_check.json",
                                   "cortex.vtp",
                                   "atlas.vti",
                                   "landmarks.json",
                                   "coil.json",
                                   "protocol.json",
                                   "overlays.json",
                                   "brain_mask_auto.nii.gz",
                                   "brain_mask_draft.nii.gz",
                                   "alignment_judged_wrong.json",
                                   "skin_fit.vtp",
                                   "home.json",
                                   "electric_field.bin",
                                   "electric_field_fluid.bin",
                                   "scalp_field.bin",
                                   "surface_distance.png",
                                   "skin_fit.png",
                                   "face_measures.png",
                                   "poses.csv",
                                   "guidance.csv",
                                   "events.jsonl",
                                   "notes.jsonl",
                                   "pulses.jsonl",
                                   "pulse_edits.jsonl",
                                   "pulse_fields.jsonl",
                                   "times.json",
                                   "pulses.csv",
                                   "report.html",
                                   "report.pdf",
                                   "returned.json",
                                   "imported.json",
                                   "sessions",
                                   "alignment_capture",
                                   "alignment_capture_judged_wrong",
                                   "face_looks",
                                   "thresholds",
                                   "overlays",
                                   "evidence",
                                   "recording"};

/// A name of the formats as it is; of another one only its ending: "[other].stl".
std::string shownName(const fs::path& name) {
  static const std::regex kEnding(R"(\.[a-z0-9]{1,5})");
  if (kKnown.count(name.string())) return name.string();
  const std::string ending = name.extension().string();
  return "[other]" + (std::regex_match(ending, kEnding) ? ending : "");
}

Json below(const fs::path& folder) {
  std::error_code fault;
  std::uintmax_t files = 0, bytes = 0;
  for (fs::recursive_directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    std::error_code odd;
    if (!at->is_regular_file(odd)) continue;
    ++files;
    bytes += at->file_size(odd);
  }
  return {{"files", files}, {"bytes", bytes}};
}

}  // namespace

Json filesOfCase(const fs::path& folder) {
  std::set<fs::path> sorted;
  std::error_code fault;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault))
    sorted.insert(at->path());
  Json list = Json::array();
  for (const fs::path& path : sorted) {
    std::error_code odd;
    Json entry{{"name", shownName(path.filename())}};
    if (fs::is_directory(path, odd))
      entry.update(below(path));
    else
      entry["bytes"] = fs::file_size(path, odd);
    list.push_back(entry);
  }
  return list;
}

}  // namespace facenav::app
