#pragma once
// Voxel-to-world map of a NIfTI file: its sform or its qform, RAS mm.

#include <nifti1_io.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "facenav/volume/nifti.h"

namespace facenav::volume {

struct ImageDeleter {
  void operator()(nifti_image* image) const { nifti_image_free(image); }
};
using ImagePtr = std::unique_ptr<nifti_image, ImageDeleter>;

/// Reads the header; null if it is damaged. Unlike nifti_image_read() it writes nothing to stderr.
ImagePtr readHeader(const std::filesystem::path& path);

/// The chosen voxel-to-world map, and the reason as text.
struct WorldMap {
  VoxelGrid grid;
  bool is_template_space = false;
  std::string name, evidence;
  std::optional<std::string> warning;
};

/// A form of the header as a map from voxels to the world, mm. `units`: the header's unit of length; an
/// unknown one is taken as mm, as other programs do.
Eigen::Affine3d formOf(const mat44& form, int units);

/// Chooses the map; automatic takes the sform if its code is > 0, else the qform. Lengths in metres or
/// micrometres become mm. where: the file's name, for messages. Throws Error: no map, the requested map is
/// absent, singular or sheared axes.
WorldMap chooseMap(const nifti_image& image, NiftiTransform choice, const std::string& where);

}  // namespace facenav::volume
