#pragma once
// Fibre tracts of other programs: TrackVis .trk, MRtrix .tck, TRX .trx, and .vtk or .vtp lines. Points are
// returned in the world of the image that the tracts were made in, RAS mm. 100 000 lines take well under a
// second. Sources: trackvis.org/docs (header of 1000 bytes), mrtrix.readthedocs.io (image data, tracks
// format), github.com/tee-ar-ex/trx-spec.

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "facenav/core/file_access.h"

namespace facenav::surface {

struct TractLines {
  std::vector<Eigen::Vector3f> points_mm;  // points of all lines, one after the other
  std::vector<std::size_t> ends;           // line i: points ends[i - 1] (0 for the first) up to ends[i]

  std::size_t lines() const { return ends.size(); }
  std::size_t begin(std::size_t line) const { return line == 0 ? 0 : ends[line - 1]; }
};

/// True for ".trk", ".tck", ".trx". (.vtk and .vtp contain lines or a surface; the content decides.)
bool isTractName(const std::filesystem::path& path);

/// Reads tracts in any of these formats. trk: the voxel order and vox_to_ras of its header are applied. vtk:
/// RAS, or LPS if its title contains SPACE=LPS. Throws Error naming the file: missing, damaged, cut short, no
/// line, no place in space.
TractLines readTracts(const std::filesystem::path& path);

/// Writes MRtrix's format, single precision, without text about its origin; whole file or nothing.
void writeTck(const TractLines& tracts, const std::filesystem::path& path,
              FileAccess access = FileAccess::owner_only);

}  // namespace facenav::surface
