#pragma once
// overlays.json: the overlays shown on a case's MRI: statistical maps, masks, tracts, surfaces. Each refers
// to a copy in CASE/overlays/, so that a case is complete on another machine and does not change when the
// original does. The copies are written anew (NIfTI, .tck, .ply) and numbered, because headers and names of
// files may contain a patient's name.

#include <filesystem>
#include <string>
#include <vector>

namespace facenav::casefile {

enum class OverlayKind { map, mask, tracts, mesh };
enum class OverlaySpace { native, mni };  // native: the case's own MRI
std::string toString(OverlayKind kind);
std::string toString(OverlaySpace space);
/// Parses the word. Throws Error for any other.
OverlayKind overlayKindFrom(const std::string& word);
OverlaySpace overlaySpaceFrom(const std::string& word);

struct OverlayEntry {
  std::string name, file;  // file: relative to the case folder
  OverlayKind kind = OverlayKind::map;
  OverlaySpace space = OverlaySpace::native;
  double opacity = 0.7;            // 0..1
  double threshold = 0, full = 1;  // maps: shown from |value| = threshold; colours end at full
  std::string unit;                // of a map's values: "z", "t", ..
  bool is_shown = true;
};

/// Throws Error if opacity is outside 0..1, threshold < 0, or full not above it.
void requireSensible(const OverlayEntry& entry);
/// Reads the entries; empty without the file. Throws Error naming file and key.
std::vector<OverlayEntry> readOverlays(const std::filesystem::path& case_folder);
/// Writes the whole file, 0600. Throws Error, also if two entries have one name.
void writeOverlays(const std::vector<OverlayEntry>& entries, const std::filesystem::path& case_folder);

}  // namespace facenav::casefile
