#pragma once
// BrainTemplate: a labelled brain in MNI space, to be registered to the patient. Colin27 (Holmes et al. 1998)
// with the AAL (Tzourio-Mazoyer et al. 2002) and Brodmann labels, from Debian's mricron-data. The files are
// read at run time and not copied into FaceNav.

#include <filesystem>
#include <map>
#include <string>

#include "facenav/volume/volume.h"

namespace facenav::atlas {

/// One label per voxel; 0: no label. The grid's world is MNI space (RAS mm).
struct LabelMap {
  std::string name;                  // "AAL", "Brodmann"
  volume::Volume labels;             // integers
  std::map<int, std::string> names;  // "Precentral_L", "BA 4"
};

struct BrainTemplate {
  volume::Volume brain;  // T1 of the brain alone, 0 elsewhere; world = MNI space
  LabelMap aal, brodmann;
};

/// Throws Error naming the Debian package if a file is missing.
BrainTemplate readColin27(const std::filesystem::path& folder = "/usr/share/mricron/templates");

struct Label {
  std::string name;        // empty: no label within the search distance
  double distance_mm = 0;  // distance to the labelled voxel; 0 inside it
};
/// The label at a point of MNI space, or the nearest one within `search_mm` (labels end at the cortex, but
/// clicks may lie outside it).
Label labelAt(const LabelMap& map, const Point<Mni>& p, double search_mm = 5.0);

}  // namespace facenav::atlas
