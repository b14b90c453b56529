#include "brain_pair.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/volume/regrid.h"

namespace facenav::atlas {
namespace {

constexpr double kMargin_mm = 12.0;  // margin around the template's brain
constexpr double kWindow_mm = 9.0;   // half width of the local normalisation: a gyrus and its neighbours
constexpr float kInside = 0.5f;

/// Bounding box of the voxels above 0 of a Volume or Mask.
template <class Image>
Eigen::AlignedBox3d boxOf(const Image& brain) {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < brain.grid.size[2]; ++k)
    for (int j = 0; j < brain.grid.size[1]; ++j) {
      // The ends of a row bound all that lies between them.
      const auto* row = &brain.voxels[brain.grid.index(0, j, k)];
      int first = 0, last = brain.grid.size[0] - 1;
      while (first <= last && !(row[first] > 0)) ++first;
      while (last > first && !(row[last] > 0)) --last;
      if (first > last) continue;
      for (const int i : {first, last}) box.extend(brain.grid.mri_from_voxel * Eigen::Vector3d(i, j, k));
    }
  if (box.isEmpty()) throw Error("the brain is empty, nothing to register the atlas to");
  return box;
}

/// Axis-parallel grid around the brain, with the given spacing.
volume::VoxelGrid gridAround(const Eigen::AlignedBox3d& box, double spacing_mm) {
  volume::VoxelGrid grid;
  const Eigen::Vector3d low_mm = box.min().array() - kMargin_mm;
  for (int a = 0; a < 3; ++a)
    grid.size[a] = int(std::ceil((box.sizes()[a] + 2 * kMargin_mm) / spacing_mm)) + 1;
  grid.mri_from_voxel = Eigen::Translation3d(low_mm) * Eigen::Scaling(spacing_mm);
  return grid;
}

/// Samples a Volume or Mask onto `grid`, band-limited to it: sampled at about the source's own spacing, then
/// averaged.
template <class Image>
ScalarField sampledOn(const Image& source, const volume::VoxelGrid& grid) {
  const double ratio = grid.spacing_mm().minCoeff() / source.grid.spacing_mm().minCoeff();
  const int fine = std::clamp(int(std::lround(ratio)), 1, 8), parts = fine * fine * fine;
  const Eigen::Affine3d to_source = source.grid.mri_from_voxel.inverse() * grid.mri_from_voxel;
  std::vector<Eigen::Vector3d> offsets;
  for (int c = 0; c < parts; ++c) {
    const Eigen::Array3d part(c % fine, c / fine % fine, c / fine / fine);
    offsets.push_back(to_source.linear() * ((part + 0.5) / fine - 0.5).matrix());
  }
  ScalarField mean(grid.size);
  forSlices(grid.size[2], [&](int k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      Eigen::Vector3d at = to_source * Eigen::Vector3d(0, j, k);
      for (int i = 0; i < grid.size[0]; ++i, at += to_source.linear().col(0)) {
        float sum = 0;
        for (const auto& offset : offsets) sum += volume::sampleLinear(source, at + offset);
        mean.values[mean.index(i, j, k)] = sum / float(parts);
      }
    }
  });
  return mean;
}

template <class Image>
volume::Volume reduced(const Image& source, const volume::VoxelGrid& grid) {
  return {grid, sampledOn(source, grid).values, {}, {}};
}

BrainPair::Moments momentsOf(const ScalarField& brain, const volume::VoxelGrid& grid) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
  double weight = 0;
  for (int k = 0; k < brain.size[2]; ++k)
    for (int j = 0; j < brain.size[1]; ++j)
      for (int i = 0; i < brain.size[0]; ++i) {
        const double w = brain.at(i, j, k);
        const Eigen::Vector3d p = grid.mri_from_voxel * Eigen::Vector3d(i, j, k);
        sum += w * p, squares += w * p.cwiseProduct(p), weight += w;
      }
  if (weight <= 0) throw Error("the brain is empty, nothing to register the atlas to");
  const Eigen::Vector3d centre = sum / weight;
  return {centre, (squares / weight - centre.cwiseProduct(centre)).cwiseMax(1.0).cwiseSqrt()};
}

/// Subtracts the local mean and divides by the local deviation, both over the brain's nodes in the window. A
/// small constant added to the variance prevents amplified noise in uniform regions.
ScalarField normalised(const ScalarField& t1, const ScalarField& brain, int radius) {
  ScalarField masked(t1.size), squares(t1.size);
  double sum = 0, sum_squares = 0, weight = 0;
  for (std::size_t n = 0; n < t1.values.size(); ++n) {
    const float w = brain.values[n];
    masked.values[n] = w * t1.values[n];
    squares.values[n] = w * t1.values[n] * t1.values[n];
    sum += masked.values[n], sum_squares += squares.values[n], weight += w;
  }
  const double mean = sum / std::max(1.0, weight);
  const float floor = float(0.01 * std::max(1e-12, sum_squares / std::max(1.0, weight) - mean * mean));
  const ScalarField share = boxMean(brain, radius);
  masked = boxMean(masked, radius);
  squares = boxMean(squares, radius);
  ScalarField normal(t1.size);
  for (std::size_t n = 0; n < t1.values.size(); ++n) {
    if (brain.values[n] < kInside || share.values[n] < 1e-3f) continue;
    const float local_mean = masked.values[n] / share.values[n];
    const float variance = squares.values[n] / share.values[n] - local_mean * local_mean;
    normal.values[n] = (t1.values[n] - local_mean) / std::sqrt(std::max(variance, 0.f) + floor);
  }
  return normal;
}

Channels channelsOf(const ScalarField& t1, ScalarField brain, double spacing_mm) {
  ScalarField normal = normalised(t1, brain, std::max(2, int(std::lround(kWindow_mm / spacing_mm))));
  return {std::move(normal), smoothed(std::move(brain), 1)};
}

}  // namespace

BrainImages::BrainImages(const volume::Volume& template_t1_fine, const volume::Volume& mri,
                         const volume::Mask& brain, double finest_mm)
    : template_box_mm(boxOf(template_t1_fine)) {
  patient_box_mm = boxOf(brain);
  volume::Mask template_mask{template_t1_fine.grid,
                             std::vector<std::uint8_t>(template_t1_fine.voxels.size())};
  for (std::size_t v = 0; v < template_mask.voxels.size(); ++v)
    template_mask.voxels[v] = template_t1_fine.voxels[v] > 0;
  const auto template_grid = gridAround(template_box_mm, finest_mm),
             patient_grid = gridAround(patient_box_mm, finest_mm);
  template_t1 = reduced(template_t1_fine, template_grid);
  template_brain = reduced(template_mask, template_grid);
  patient_t1 = reduced(mri, patient_grid);
  patient_brain = reduced(brain, patient_grid);
}

BrainPair::BrainPair(const BrainImages& images, double spacing_mm)
    : grid_(gridAround(images.template_box_mm, spacing_mm)),
      patient_grid_(gridAround(images.patient_box_mm, spacing_mm)),
      patient_t1_(sampledOn(images.patient_t1, patient_grid_)),
      patient_brain_(sampledOn(images.patient_brain, patient_grid_)) {
  const ScalarField inside = sampledOn(images.template_brain, grid_);
  template_moments_ = momentsOf(inside, grid_);
  fixed_ = channelsOf(sampledOn(images.template_t1, grid_), inside, spacing_mm);
  patient_moments_ = momentsOf(patient_brain_, patient_grid_);
}

Channels BrainPair::warped(const Eigen::Affine3d& mri_from_mni, const VectorField* displacement) const {
  const Eigen::Affine3f to_patient =
      (patient_grid_.mri_from_voxel.inverse() * mri_from_mni * grid_.mri_from_voxel).cast<float>();
  ScalarField t1(grid_.size), brain(grid_.size);
  forSlices(grid_.size[2], [&](int k) {
    for (int j = 0; j < grid_.size[1]; ++j)
      for (int i = 0; i < grid_.size[0]; ++i) {
        const std::size_t n = t1.index(i, j, k);
        Eigen::Vector3f at{float(i), float(j), float(k)};
        if (displacement)
          for (int a = 0; a < 3; ++a) at[a] += (*displacement)[a].values[n];
        at = to_patient * at;
        const Cell cell(patient_t1_.size, at);
        t1.values[n] = cell.of(patient_t1_);
        brain.values[n] = cell.of(patient_brain_);
      }
  });
  return channelsOf(t1, std::move(brain), grid_.spacing_mm()[0]);
}

double BrainPair::dice(const Channels& moving) const {
  double both = 0, all = 0;
  for (std::size_t n = 0; n < moving.brain.values.size(); ++n) {
    const bool a = fixed_.brain.values[n] >= kInside, b = moving.brain.values[n] >= kInside;
    both += a && b, all += a + b;
  }
  return all > 0 ? 2 * both / all : 0;
}

double BrainPair::correlation(const Channels& moving) const {
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t n = 0; n < moving.t1.values.size(); ++n) {
    if (fixed_.brain.values[n] < kInside || moving.brain.values[n] < kInside) continue;
    const double a = fixed_.t1.values[n], b = moving.t1.values[n];
    ab += a * b, aa += a * a, bb += b * b;
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

}  // namespace facenav::atlas
