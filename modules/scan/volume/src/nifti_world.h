#pragma once
// Where a NIfTI file's voxels lie: its sform or its qform, RAS mm.

#include <nifti1_io.h>

#include <optional>
#include <string>

#include "facenav/volume/nifti.h"

namespace facenav::volume {

/// The voxel-to-world map that was chosen, and in words why.
struct WorldMap {
  VoxelGrid grid;
  bool is_template_space = false;
  std::string name, evidence;
  std::optional<std::string> warning;
};

/// The map that choice asks for; automatic takes the sform if its code is > 0, else the qform. Lengths in
/// metres or micrometres become mm. where: the file's name, for messages. Throws Error: no map, the requested
/// map is absent, singular or sheared axes.
WorldMap chooseMap(const nifti_image& image, NiftiTransform choice, const std::string& where);

}  // namespace facenav::volume
