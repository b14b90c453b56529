// Files of the field on the cortex: written, and compared with.

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/efield/field_msh.h"
#include "facenav/plan/cortex_field.h"
#include "facenav/surface/vector_file.h"
#include "facenav/volume/nifti.h"
#include "imported_field_checks.h"
#include "imported_samples.h"

namespace facenav::steps {
namespace {

bool endsIn(const std::filesystem::path& path, const char* extension) {
  return path.extension() == extension;
}

bool isNifti(const std::filesystem::path& path) {
  return endsIn(path, ".nii") || (endsIn(path, ".gz") && endsIn(path.stem(), ".nii"));
}

/// The other program's field where it is compared: on its own cortex, else of a volume on the case's one.
efield::FieldSamples samplesToCompare(const std::filesystem::path& file, const std::filesystem::path& surface,
                                      const FieldSurfaces& surfaces) {
  if (fieldFileOf(file) == FieldFile::msh) return efield::readFieldMsh(file);
  const auto other = readOtherField(file, surface);
  return other.image ? samplesAt(*other.image, surfaces.cortex.vertices_mm) : other.samples.grey;
}

/// Fills in what both fields (3 x n vectors or a row of magnitudes) say; `ours` after scaling.
void compare(const Eigen::MatrixXd& ours, const Eigen::MatrixXd& theirs, const Eigen::Matrix3Xd& points_mm,
             FieldComparison& result) {
  result.points = int(theirs.cols());
  result.relative_error = (ours - theirs).norm() / theirs.norm();
  Eigen::Index at_ours = 0, at_theirs = 0;
  const double peak = ours.colwise().norm().maxCoeff(&at_ours);
  result.peak_ratio = peak / theirs.colwise().norm().maxCoeff(&at_theirs);
  result.peak_shift_mm = (points_mm.col(at_ours) - points_mm.col(at_theirs)).norm();
}

/// The part of the samples that is compared: vectors, or magnitudes as one row.
Eigen::MatrixXd comparable(const Eigen::Matrix3Xd& field, bool has_vectors) {
  if (has_vectors) return field;
  return field.colwise().norm();
}

}  // namespace

bool isFieldName(const std::filesystem::path& path) {
  return endsIn(path, ".vtp") || endsIn(path, ".msh") || isNifti(path);
}

void writeField(const HeadField& head, const FieldSurfaces& surfaces, const efield::CoilDipoles& coil,
                const guidance::Target& target, double rate_A_per_us, const std::filesystem::path& path) {
  const CoilPose pose = coilPoseOf(target);
  if (!isFieldName(path))
    throw Error("a field is written as .vtp, .msh, .nii or .nii.gz", path.string(),
                "give one of these names");
  if (isNifti(path)) return volume::writeNifti(fieldVolume(head, surfaces, coil, pose, rate_A_per_us), path);
  const auto& vertices = surfaces.cortex.vertices_mm;
  const Eigen::Map<const Eigen::Matrix3Xd> points(vertices[0].data(), 3, Eigen::Index(vertices.size()));
  const Eigen::Matrix3Xd field = rate_A_per_us * head.at(coil, pose, points);
  if (endsIn(path, ".msh")) return efield::writeFieldMsh(surfaces.cortex, field, path);
  surface::VectorSurface result{surfaces.cortex, {}};
  for (Eigen::Index i = 0; i < field.cols(); ++i) result.vectors.push_back(field.col(i).cast<float>());
  surface::writeVectors(result, "E", path);
}

FieldComparison compareField(const HeadField& head, const FieldSurfaces& surfaces,
                             const efield::CoilDipoles& coil, const guidance::Target& target,
                             const std::filesystem::path& file, std::optional<double> rate_A_per_us,
                             const std::filesystem::path& surface) {
  const auto imported = samplesToCompare(file, surface, surfaces);
  requireOnCortex(imported.points_mm, surfaces.cortex, file);
  const bool has_vectors = imported.field.cols() > 0;
  const Eigen::MatrixXd theirs =
      has_vectors ? Eigen::MatrixXd(imported.field) : Eigen::MatrixXd(imported.magnitude.transpose());
  if (!(theirs.norm() > 0)) throw Error("the field is 0 everywhere", file.string(), "export it again");
  Eigen::MatrixXd ours = comparable(
      rate_A_per_us.value_or(1) * head.at(coil, coilPoseOf(target), imported.points_mm), has_vectors);
  FieldComparison result;
  result.is_scaled = !rate_A_per_us;
  result.scale = ours.cwiseProduct(theirs).sum() / ours.squaredNorm();
  if (result.is_scaled) ours *= result.scale;
  compare(ours, theirs, imported.points_mm, result);
  return result;
}

FieldComparison compareModels(const HeadField& head, const HeadField& other, const FieldSurfaces& surfaces,
                              const efield::CoilDipoles& coil, const guidance::Target& target) {
  const auto& vertices = surfaces.cortex.vertices_mm;
  const Eigen::Map<const Eigen::Matrix3Xd> points_mm(vertices[0].data(), 3, Eigen::Index(vertices.size()));
  const CoilPose pose = coilPoseOf(target);
  const Eigen::MatrixXd ours = head.at(coil, pose, points_mm), theirs = other.at(coil, pose, points_mm);
  FieldComparison result;
  result.scale = ours.cwiseProduct(theirs).sum() / ours.squaredNorm();
  compare(ours, theirs, points_mm, result);
  return result;
}

}  // namespace facenav::steps
