// Files of the field on the cortex: written, and compared with.

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/efield/field_msh.h"
#include "facenav/plan/cortex_field.h"
#include "facenav/surface/closest_point.h"
#include "facenav/surface/vector_file.h"
#include "facenav/volume/nifti.h"

namespace facenav::steps {
namespace {

constexpr double kFarthest_mm = 5;       // median distance of an imported field's points from the cortex
constexpr Eigen::Index kChecked = 2000;  // points whose distance is measured

bool endsIn(const std::filesystem::path& path, const char* extension) {
  return path.extension() == extension;
}

bool isNifti(const std::filesystem::path& path) {
  return endsIn(path, ".nii") || (endsIn(path, ".gz") && endsIn(path.stem(), ".nii"));
}

efield::FieldSamples importedField(const std::filesystem::path& file) {
  if (endsIn(file, ".msh")) return efield::readFieldMsh(file);
  if (!endsIn(file, ".vtp"))
    throw Error("a field to compare with is a .msh or .vtp file", file.string(), "export it as one of them");
  const auto read = surface::readVectors(file, "E");
  efield::FieldSamples samples;
  samples.points_mm.resize(3, Eigen::Index(read.vectors.size()));
  samples.field.resize(3, samples.points_mm.cols());
  for (Eigen::Index i = 0; i < samples.points_mm.cols(); ++i) {
    samples.points_mm.col(i) = read.mesh.vertices_mm[std::size_t(i)];
    samples.field.col(i) = read.vectors[std::size_t(i)].cast<double>();
  }
  samples.magnitude = samples.field.colwise().norm().transpose();
  return samples;
}

void requireOnCortex(const Eigen::Matrix3Xd& points_mm, const surface::TriangleMesh& cortex,
                     const std::filesystem::path& file) {
  const surface::ClosestPoint tree(cortex);
  std::vector<double> away_mm;
  const Eigen::Index step = std::max<Eigen::Index>(1, points_mm.cols() / kChecked);
  for (Eigen::Index i = 0; i < points_mm.cols(); i += step)
    away_mm.push_back(tree.nearest(Point<Mri>(Eigen::Vector3d(points_mm.col(i)))).distance_mm);
  std::nth_element(away_mm.begin(), away_mm.begin() + long(away_mm.size() / 2), away_mm.end());
  const double median_mm = away_mm[away_mm.size() / 2];
  if (!(median_mm <= kFarthest_mm))
    throw Error(formatted("the field lies on another cortex: half of its points are more than %.0f mm away",
                          median_mm),
                file.string(), "import a field of this patient, in the coordinates of the case's MRI");
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
                             const std::filesystem::path& file, std::optional<double> rate_A_per_us) {
  const auto imported = importedField(file);
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
