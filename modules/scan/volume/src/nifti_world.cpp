#include "nifti_world.h"

#include <nifti1_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"

namespace facenav::volume {
namespace {

Eigen::Affine3d toAffine(const mat44& m) {
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) affine(r, c) = m.m[r][c];
  return affine;
}

bool isSingular(const Eigen::Affine3d& affine) {
  const Eigen::Matrix3d l = affine.linear();
  const Eigen::Vector3d lengths = l.colwise().norm();
  return !affine.matrix().allFinite() || !(lengths.minCoeff() > 0) ||
         std::abs(l.determinant()) < 1e-3 * lengths.prod();
}

/// Cosine of the angle between the two voxel axes that are least at right angles.
double shearOf(const Eigen::Affine3d& affine) {
  const Eigen::Matrix3d l = affine.linear();
  const Eigen::Matrix3d unit = l * l.colwise().norm().cwiseInverse().asDiagonal();
  return (unit.transpose() * unit - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}
constexpr double kLargestShear = 0.02;

/// Throws Error for axes that are not at right angles. `other` is the file's other map, if it has one.
void requireOrthogonal(const Eigen::Affine3d& affine, const std::string& name, const Eigen::Affine3d* other,
                       const std::string& other_name, const std::string& where) {
  if (isSingular(affine)) throw Error("orientation matrix is singular", where, "export the volume again");
  const double shear = shearOf(affine);
  if (shear <= kLargestShear) return;
  const bool is_other_sound = other && !isSingular(*other) && shearOf(*other) <= kLargestShear;
  throw Error("the voxel axes of its " + name +
                  formatted(" are sheared by %.1f degrees", std::asin(std::min(1.0, shear)) * kDegPerRad) +
                  (is_other_sound ? "; those of its " + other_name + " are at right angles" : ""),
              where,
              is_other_sound ? "take the " + other_name + " (--nifti-transform " + other_name +
                                   "), and compare left and right with the person"
                             : "resample the volume onto an orthogonal grid");
}

/// Throws Error for voxels of an impossible size, and names the unit that would make them possible.
void requirePossibleUnits(const Eigen::Affine3d& affine, int units, const std::string& where) {
  constexpr double kLeast_mm = 0.02, kMost_mm = 60, kUsual_mm = 0.2, kCoarse_mm = 10;
  const Eigen::Vector3d edges_mm = affine.linear().colwise().norm();
  if (edges_mm.minCoeff() >= kLeast_mm && edges_mm.maxCoeff() <= kMost_mm) return;
  const std::string stated = units == NIFTI_UNITS_METER    ? "metre"
                             : units == NIFTI_UNITS_MICRON ? "micrometre"
                             : units == NIFTI_UNITS_MM     ? "mm"
                                                           : "";
  const double stated_mm = units == NIFTI_UNITS_METER ? 1e3 : units == NIFTI_UNITS_MICRON ? 1e-3 : 1.0;
  std::string likely;
  for (const auto& [name, unit_mm] : {std::pair("mm", 1.0), {"metres", 1e3}, {"micrometres", 1e-3}}) {
    const Eigen::Vector3d as_mm = edges_mm * (unit_mm / stated_mm);
    if (as_mm.minCoeff() >= kUsual_mm && as_mm.maxCoeff() <= kCoarse_mm) likely = name;
  }
  throw Error(
      formatted("its voxels would be %.3g x %.3g x %.3g mm: ", edges_mm[0], edges_mm[1], edges_mm[2]) +
          (stated.empty() ? "its header names no unit of length" : "the unit in its header is " + stated) +
          (likely.empty() ? "" : ", its values look like " + likely),
      where, "correct the unit in the header (xyzt_units), or export it again from DICOM");
}

/// The coordinate space of an xform code (nifti1.h).
std::string spaceOf(int code) {
  constexpr const char* kSpaces[] = {"absent",    "scanner", "aligned to another scan",
                                     "Talairach", "MNI",     "template"};
  return code >= 0 && code < 6 ? kSpaces[code] : "code " + std::to_string(code);
}

double largestDistance_mm(const VoxelGrid& a, const VoxelGrid& b) {
  double worst_mm = 0;
  for (int c = 0; c < 8; ++c) {
    const Eigen::Vector3d ijk((c & 1) * a.size[0], ((c >> 1) & 1) * a.size[1], (c >> 2) * a.size[2]);
    worst_mm = std::max(worst_mm, (a.toMri(ijk).mm - b.toMri(ijk).mm).norm());
  }
  return worst_mm;
}

/// Describes a contradiction that the user must see; empty if the two maps do not contradict each other.
std::string contradiction(const VoxelGrid& sform, const VoxelGrid& qform) {
  constexpr double kLargestScale = 0.02;  // atlas-sized heads differ by 5-15 %
  const double handedness =
      sform.mri_from_voxel.linear().determinant() * qform.mri_from_voxel.linear().determinant();
  if (handedness < 0) return "sform and qform are mirror images: they disagree about left and right";
  const Eigen::Vector3d ratio = sform.spacing_mm().cwiseQuotient(qform.spacing_mm());
  const double scale = (ratio.array() - 1.0).abs().maxCoeff();
  if (scale > kLargestScale)
    return "sform and qform disagree about the size of the head by " +
           std::to_string(std::lround(100 * scale)) + " %";
  return {};
}

}  // namespace

ImagePtr readHeader(const std::filesystem::path& path) {
  nifti_set_debug_level(0);
  int is_swapped = 0;
  const std::unique_ptr<nifti_1_header, void (*)(void*)> header(
      nifti_read_header(path.c_str(), &is_swapped, 0), std::free);
  if (!header) return nullptr;
  int voxel_bytes = 0, swap_bytes = 0;
  nifti_datatype_sizes(header->datatype, &voxel_bytes, &swap_bytes);
  // What nifti_convert_nhdr2nim() refuses, with a line of its own at every level of debugging.
  const bool has_dimensions = header->dim[0] >= 1 && header->dim[0] <= 7 && header->dim[1] >= 1;
  if (!has_dimensions || voxel_bytes == 0) return nullptr;
  return ImagePtr(nifti_image_read(path.c_str(), 0));
}

Eigen::Affine3d formOf(const mat44& form, int units) {
  Eigen::Affine3d affine = toAffine(form);
  const double scale = units == NIFTI_UNITS_METER ? 1e3 : units == NIFTI_UNITS_MICRON ? 1e-3 : 1.0;
  affine.linear() *= scale;
  affine.translation() *= scale;
  return affine;
}

WorldMap chooseMap(const nifti_image& image, NiftiTransform choice, const std::string& where) {
  constexpr double kAgreement_mm = 0.1;
  const bool has_sform = image.sform_code > 0, has_qform = image.qform_code > 0;
  if (!has_sform && !has_qform)
    throw Error("has neither sform nor qform, so left and right are not known", where,
                "export it again from DICOM, e.g. with dcm2niix");
  const bool is_sform = choice == NiftiTransform::automatic ? has_sform : choice == NiftiTransform::sform;
  WorldMap map;
  map.name = is_sform ? "sform" : "qform";
  if (!(is_sform ? has_sform : has_qform))
    throw Error("has no " + map.name, where, std::string("choose the ") + (is_sform ? "qform" : "sform"));
  VoxelGrid sform, qform;
  sform.size = qform.size = {image.nx, image.ny, image.nz};
  sform.mri_from_voxel = formOf(image.sto_xyz, image.xyz_units);
  qform.mri_from_voxel = formOf(image.qto_xyz, image.xyz_units);
  const int code = is_sform ? image.sform_code : image.qform_code;
  map.is_template_space = code >= NIFTI_XFORM_TALAIRACH;
  map.grid = is_sform ? sform : qform;
  const VoxelGrid& unused = is_sform ? qform : sform;
  requireOrthogonal(map.grid.mri_from_voxel, map.name,
                    (is_sform ? has_qform : has_sform) ? &unused.mri_from_voxel : nullptr,
                    is_sform ? "qform" : "sform", where);
  requirePossibleUnits(map.grid.mri_from_voxel, image.xyz_units, where);
  map.evidence =
      map.name + " (" + spaceOf(code) + ")" + (choice == NiftiTransform::automatic ? "" : ", as asked for");
  if (!has_sform || !has_qform) return map;
  const std::string other = is_sform ? "qform" : "sform";
  const std::string contradicted = contradiction(sform, qform);
  const double worst_mm = largestDistance_mm(sform, qform);
  if (worst_mm <= kAgreement_mm) {
    map.evidence += "; the " + other + " agrees";
    return map;
  }
  const std::string far = formatted(worst_mm < 10 ? "%.1f mm" : "%.0f mm", worst_mm);
  map.evidence += "; the " + other + " (" + spaceOf(is_sform ? image.qform_code : image.sform_code) +
                  ") lies up to " + far + " off";
  map.warning = (contradicted.empty() ? "sform and qform disagree by up to " + far : contradicted) +
                "; the " + map.name + " is used";
  if (choice == NiftiTransform::automatic && !contradicted.empty())
    *map.warning +=
        ": find out which one is right before this case is used (--nifti-transform qform takes the other)";
  return map;
}

}  // namespace facenav::volume
