#include "imported_samples.h"

#include <cmath>
#include <fstream>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/surface/surface_values.h"
#include "facenav/surface/vector_file.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/nifti_forms.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;

/// The first bytes of a file; of one that may be GIFTI all of them.
std::string startOf(const fs::path& file) {
  if (!fs::is_regular_file(file)) throw Error("file does not exist", file.string(), "check the path");
  std::string start(1024, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), std::streamsize(start.size()));
  start.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
  return start.find("<GIFTI") != std::string::npos || start.find("<!DOCTYPE GIFTI") != std::string::npos
             ? readWholeFile(file)
             : start;
}

bool isNiftiStart(const std::string& start) {
  if (start.size() > 2 && start.compare(0, 2, "\x1f\x8b") == 0) return true;  // compressed: nothing else is
  return start.size() >= 348 && (start.compare(344, 3, "n+1") == 0 || start.compare(344, 3, "ni1") == 0);
}

efield::HeadFieldSamples onNodes(efield::FieldSamples samples) {
  samples.weight = Eigen::VectorXd::Ones(samples.points_mm.cols());
  efield::HeadFieldSamples head;
  head.grey = head.brain = std::move(samples);
  return head;
}

efield::FieldSamples vtpSamples(const fs::path& file) {
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

efield::FieldSamples valuesOn(const fs::path& file, const fs::path& surface_file) {
  if (surface_file.empty())
    throw Error("holds values alone: the surface that they belong to is another file", file.string(),
                "name it with --surface, such as lh.central.gii");
  const auto values = surface::readSurfaceValues(file);
  const auto mesh = surface::readGiftiSurface(surface_file);
  if (values.size() != mesh.vertices_mm.size())
    throw Error(formatted("holds %zu values, but the surface has %zu vertices", values.size(),
                          mesh.vertices_mm.size()),
                file.string(), "name the surface that the field was written for (lh with lh, rh with rh)");
  efield::FieldSamples samples;
  samples.points_mm.resize(3, Eigen::Index(values.size()));
  samples.magnitude.resize(Eigen::Index(values.size()));
  for (Eigen::Index i = 0; i < samples.magnitude.size(); ++i) {
    samples.points_mm.col(i) = mesh.vertices_mm[std::size_t(i)];
    samples.magnitude[i] = values[std::size_t(i)];
  }
  if (samples.magnitude.size() > 0 && samples.magnitude.minCoeff() < 0)
    throw Error("holds values below 0: a part of the field, not its magnitude", file.string(),
                "give the overlay of the magnitude (E.magn, E.norm)");
  return samples;
}

FieldImage imageOf(const fs::path& file, const volume::NiftiForms& forms) {
  FieldImage image;
  if (forms.values != 3) {
    image.magnitude = volume::readNifti(file).volume;
    for (float& value : image.magnitude.voxels)
      if (value < 0)
        throw Error("holds values below 0: a part of the field, not its magnitude", file.string(),
                    "give the image of the magnitude (magnE), or of the vectors (E)");
    return image;
  }
  auto read = volume::readNiftiVectors(file);
  image.magnitude.grid = read.grid;
  for (auto& vector : read.vectors) {
    if (!vector.allFinite()) vector.setZero();  // outside the head
    image.magnitude.voxels.push_back(vector.norm());
  }
  image.vectors = std::move(read.vectors);
  return image;
}

void addSample(const FieldImage& image, const Eigen::Vector3i& v, const Eigen::Vector3d& place_mm,
               std::vector<Eigen::Vector3d>& places_mm, std::vector<std::size_t>& voxels) {
  const auto& grid = image.magnitude.grid;
  if (!grid.contains(v.x(), v.y(), v.z())) return;
  const std::size_t voxel = grid.index(v.x(), v.y(), v.z());
  if (!(image.magnitude.voxels[voxel] > 0)) return;
  places_mm.push_back(place_mm);
  voxels.push_back(voxel);
}

efield::FieldSamples samplesOf(const FieldImage& image, const std::vector<Eigen::Vector3d>& places_mm,
                               const std::vector<std::size_t>& voxels) {
  efield::FieldSamples samples;
  const auto count = Eigen::Index(voxels.size());
  samples.points_mm.resize(3, count);
  samples.magnitude.resize(count);
  samples.weight = Eigen::VectorXd::Constant(count, image.magnitude.grid.voxelVolume_mm3());
  if (!image.vectors.empty()) samples.field.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t voxel = voxels[std::size_t(i)];
    samples.points_mm.col(i) = places_mm[std::size_t(i)];
    samples.magnitude[i] = image.magnitude.voxels[voxel];
    if (!image.vectors.empty()) samples.field.col(i) = image.vectors[voxel].cast<double>();
  }
  return samples;
}

}  // namespace

FieldFile fieldFileOf(const fs::path& file) {
  if (fs::is_directory(file)) return FieldFile::other;
  const std::string start = startOf(file);
  if (start.compare(0, 11, "$MeshFormat") == 0 || start.compare(0, 9, "$Comments") == 0)
    return FieldFile::msh;
  if (surface::holdsSurfaceValues(start)) return FieldFile::surface_values;
  if (isNiftiStart(start)) return FieldFile::nifti;
  if (start.find("<VTKFile") != std::string::npos && start.find("PolyData") != std::string::npos)
    return FieldFile::vtp;
  return FieldFile::other;
}

OtherField readOtherField(const fs::path& file, const fs::path& surface) {
  OtherField result;
  switch (fieldFileOf(file)) {
    case FieldFile::msh:
      result.samples = efield::readHeadFieldMsh(file);
      result.words = result.samples.fills_brain ? "mesh of gmsh 2.2 with the brain's volume"
                                                : "mesh of gmsh 2.2 with a surface";
      return result;
    case FieldFile::nifti: {
      const auto forms = volume::readNiftiForms(file);
      if (forms.is_template_space)
        throw Error("lies in the space of a template, by its header", file.string(),
                    "give the field in the subject's space (subject_volumes)");
      result.image = imageOf(file, forms);
      result.words = "NIfTI volume";
      return result;
    }
    case FieldFile::surface_values:
      result.samples = onNodes(valuesOn(file, surface));
      result.words = "values on a surface of the cortex";
      return result;
    case FieldFile::vtp:
      result.samples = onNodes(vtpSamples(file));
      result.words = "VTK surface";
      return result;
    case FieldFile::other:
      break;
  }
  throw Error("holds no electric field that is known", file.string(),
              "give a .msh, a NIfTI, a .vtp, or an overlay with its surface");
}

efield::FieldSamples samplesIn(const FieldImage& image, const volume::Mask& mask) {
  const auto& grid = image.magnitude.grid;
  std::vector<Eigen::Vector3d> places_mm;
  std::vector<std::size_t> voxels;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const auto p = grid.toMri({double(i), double(j), double(k)});
        const Eigen::Vector3d at = mask.grid.toVoxel(p).array().round();
        if (at.cwiseAbs().maxCoeff() > 1e6 || !mask.grid.contains(int(at.x()), int(at.y()), int(at.z())))
          continue;
        if (mask.at(int(at.x()), int(at.y()), int(at.z())))
          addSample(image, {i, j, k}, p.mm, places_mm, voxels);
      }
  return samplesOf(image, places_mm, voxels);
}

efield::FieldSamples samplesAt(const FieldImage& image, const std::vector<Eigen::Vector3d>& points_mm) {
  std::vector<Eigen::Vector3d> places_mm;
  std::vector<std::size_t> voxels;
  for (const auto& p_mm : points_mm) {
    const Eigen::Vector3d at = image.magnitude.grid.toVoxel(Point<Mri>(p_mm)).array().round();
    if (at.cwiseAbs().maxCoeff() < 1e6) addSample(image, at.cast<int>(), p_mm, places_mm, voxels);
  }
  return samplesOf(image, places_mm, voxels);
}

}  // namespace facenav::steps
