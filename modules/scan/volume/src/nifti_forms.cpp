#include "facenav/volume/nifti_forms.h"

#include <nifti1_io.h>

#include "facenav/core/error.h"
#include "nifti_world.h"

namespace facenav::volume {

NiftiForms readNiftiForms(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path))
    throw Error("file does not exist", path.string(), "check the path");
  nifti_set_debug_level(0);
  const ImagePtr image = is_nifti_file(path.c_str()) < 0 ? nullptr : readHeader(path);
  if (!image) throw Error("is not a NIfTI file", path.string(), "export it again as .nii.gz");
  if (image->nx < 1 || image->ny < 1 || image->nz < 1)
    throw Error("holds no 3-D volume", path.string(), "choose the T1");
  const WorldMap map = chooseMap(*image, NiftiTransform::automatic, path.string());
  NiftiForms forms;
  forms.grid = map.grid;
  forms.used = map.name;
  if (image->sform_code > 0) forms.sform = formOf(image->sto_xyz, image->xyz_units);
  if (image->qform_code > 0) forms.qform = formOf(image->qto_xyz, image->xyz_units);
  forms.quatern = {image->quatern_b, image->quatern_c, image->quatern_d};
  forms.offset = {image->qoffset_x, image->qoffset_y, image->qoffset_z};
  forms.pixdim = {image->qfac < 0 ? -1.0 : 1.0, image->dx, image->dy, image->dz};
  forms.is_template_space = map.is_template_space;
  const auto voxels = std::size_t(image->nx) * std::size_t(image->ny) * std::size_t(image->nz);
  forms.values = int(image->nvox / voxels);
  forms.holds_fractions = image->datatype == DT_FLOAT32 || image->datatype == DT_FLOAT64;
  return forms;
}

}  // namespace facenav::volume
