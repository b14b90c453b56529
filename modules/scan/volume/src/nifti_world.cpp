#include "nifti_world.h"

#include <nifti1_io.h>

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"

namespace facenav::volume {
namespace {

Eigen::Affine3d toAffine(const mat44& m) {
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) affine(r, c) = m.m[r][c];
  return affine;
}

void requireOrthogonal(const Eigen::Affine3d& affine, const std::string& where) {
  const Eigen::Matrix3d l = affine.linear();
  if (!l.allFinite() || std::abs(l.determinant()) < 1e-9)
    throw Error("orientation matrix is singular", where, "export the volume again");
  const Eigen::Matrix3d unit = l * l.colwise().norm().cwiseInverse().asDiagonal();
  if ((unit.transpose() * unit - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > 0.02)
    throw Error("voxel axes are sheared", where, "resample the volume onto an orthogonal grid");
}

/// The coordinate space of an xform code (nifti1.h).
std::string spaceOf(int code) {
  constexpr const char* kSpaces[] = {"absent",    "scanner", "aligned to another scan",
                                     "Talairach", "MNI",     "template"};
  return code >= 0 && code < 6 ? kSpaces[code] : "code " + std::to_string(code);
}

/// Converts lengths from the header's unit to mm; an unknown unit is taken as mm, as other programs do.
Eigen::Affine3d inMillimetres(Eigen::Affine3d affine, int units) {
  const double scale = units == NIFTI_UNITS_METER ? 1e3 : units == NIFTI_UNITS_MICRON ? 1e-3 : 1.0;
  affine.linear() *= scale;
  affine.translation() *= scale;
  return affine;
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
  sform.mri_from_voxel = inMillimetres(toAffine(image.sto_xyz), image.xyz_units);
  qform.mri_from_voxel = inMillimetres(toAffine(image.qto_xyz), image.xyz_units);
  const int code = is_sform ? image.sform_code : image.qform_code;
  map.is_template_space = code >= NIFTI_XFORM_TALAIRACH;
  map.grid = is_sform ? sform : qform;
  requireOrthogonal(map.grid.mri_from_voxel, where);
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
  const std::string far = std::to_string(int(std::ceil(worst_mm))) + " mm";
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
