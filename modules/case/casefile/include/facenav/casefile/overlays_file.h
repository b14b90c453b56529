#pragma once
// overlays.json: what is shown over a case's MRI: statistical maps, masks, tracts, surfaces. Each refers to a
// copy in CASE/overlays/, so that a case is whole on another machine and does not change when the original
// does. The copies are written anew (NIfTI, .tck, .ply) and numbered: headers and names of files may hold a
// patient's name.

#include <filesystem>
#include <string>
#include <vector>

namespace facenav::casefile {

enum class OverlayKind { map, mask, tracts, mesh };
enum class OverlaySpace { native, mni };  // native: the case's own MRI
std::string toString(OverlayKind kind);
std::string toString(OverlaySpace space);
/// Throw Error for any other word.
OverlayKind overlayKindFrom(const std::string& word);
OverlaySpace overlaySpaceFrom(const std::string& word);

struct OverlayEntry {
  std::string name, file;  // file: relative to the case folder
  OverlayKind kind = OverlayKind::map;
  OverlaySpace space = OverlaySpace::native;
  double opacity = 0.7;            // 0..1
  double threshold = 0, full = 1;  // of a map: shown from |value| = threshold; its colours end at full
  std::string unit;                // of a map's values: "z", "t", ..
  bool is_shown = true;
};

/// Throws Error: opacity outside 0..1, threshold < 0, full not above it.
void requireSensible(const OverlayEntry& entry);
/// Empty without the file. Throws Error naming file and key.
std::vector<OverlayEntry> readOverlays(const std::filesystem::path& case_folder);
/// Writes the whole file, 0600. Throws Error, also for two of one name.
void writeOverlays(const std::vector<OverlayEntry>& entries, const std::filesystem::path& case_folder);

}  // namespace facenav::casefile
