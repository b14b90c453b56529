#include "facenav/evaluation/volume_perturbation.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "facenav/geometry/rotation.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"

namespace facenav::evaluation {
namespace {

using volume::Mask;
using volume::Volume;
using volume::VoxelGrid;

constexpr double kHead_mm = 90;        // half the size of a head: scale of the bias field
constexpr double kScalpFrom_mm = 6.0;  // distance outside the brain

VolumePerturbation turned(int axis, double deg) {
  VolumePerturbation p;
  p.name = std::string("turned ") + (deg < 0 ? "-" : "+") + std::to_string(int(std::abs(deg))) +
           " deg about " + "xyz"[axis];
  p.turn_deg[axis] = deg;
  return p;
}

template <class Value>
VolumePerturbation with(const std::string& name, Value VolumePerturbation::*field, Value value) {
  VolumePerturbation p;
  p.name = name;
  p.*field = value;
  return p;
}

/// Maps original world coordinates to perturbed ones.
Eigen::Affine3d movedFromOriginal(const VoxelGrid& original, const VolumePerturbation& p) {
  const Eigen::Vector3d centre = original.centre().mm;
  Eigen::Matrix3d linear = p.size * Eigen::Matrix3d::Identity();
  for (int a = 0; a < 3; ++a)
    linear =
        linear * Eigen::AngleAxisd(p.turn_deg[a] * kRadPerDeg, Eigen::Vector3d::Unit(a)).toRotationMatrix();
  return Eigen::Translation3d(centre) * Eigen::Affine3d(linear) * Eigen::Translation3d(-centre);
}

/// Repeats the lowest slice (RAS order) downwards.
Volume withNeck(const Volume& volume, double neck_mm) {
  const Volume whole = volume::toRasOrder(volume);
  const int more = int(std::lround(neck_mm / whole.grid.spacing_mm().z()));
  Volume out = whole;
  out.grid.size[2] += more;
  out.grid.mri_from_voxel.translate(Eigen::Vector3d(0, 0, -more));
  const auto slice = std::ptrdiff_t(whole.grid.size[0]) * whole.grid.size[1];
  std::vector<float> neck;
  for (int k = 0; k < more; ++k) neck.insert(neck.end(), whole.voxels.begin(), whole.voxels.begin() + slice);
  out.voxels.insert(out.voxels.begin(), neck.begin(), neck.end());
  return out;
}

Volume resampledTo(const Volume& volume, double spacing_mm) {
  Volume out{volume::isotropicGrid(volume.grid, spacing_mm), {}, volume.modality, volume.orientation_source};
  out.voxels.assign(out.grid.count(), 0);
  const int fine = std::max(1, int(std::ceil(spacing_mm / volume.grid.spacing_mm().minCoeff() - 1e-6)));
  for (int part = 0; part < fine * fine * fine; ++part) {
    const Eigen::Vector3d at(part % fine, part / fine % fine, part / fine / fine);
    VoxelGrid grid = out.grid;
    grid.mri_from_voxel.translate(((at.array() + 0.5) / fine - 0.5).matrix());
    const Volume sample = volume::resample(volume, grid);
    for (std::size_t v = 0; v < out.voxels.size(); ++v)
      out.voxels[v] += sample.voxels[v] / float(fine * fine * fine);
  }
  return out;
}

/// Random second-order polynomial; its largest value over the head's ball is about 1.
struct SmoothField {
  explicit SmoothField(std::mt19937& random) {
    std::normal_distribution<double> normal;
    for (double& c : linear) c = normal(random);
    for (double& c : quadratic) c = normal(random);
    double most = 1e-9;
    for (int n = 0; n < 500; ++n)
      most = std::max(
          most, std::abs(raw(Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized())));
    scale = 1 / most;
  }
  double raw(const Eigen::Vector3d& p) const {
    double sum = 0;
    for (int a = 0; a < 3; ++a)
      sum += linear[a] * p[a] + quadratic[a] * p[a] * p[a] + quadratic[3 + a] * p[a] * p[(a + 1) % 3];
    return sum;
  }
  double operator()(const Eigen::Vector3d& p) const { return scale * raw(p); }
  double linear[3], quadratic[6], scale = 1;
};

void addBias(Volume& volume, double bias, std::mt19937& random) {
  const SmoothField field(random);
  const Eigen::Vector3d centre = volume.grid.centre().mm;
  std::size_t v = 0;
  for (int k = 0; k < volume.grid.size[2]; ++k)
    for (int j = 0; j < volume.grid.size[1]; ++j)
      for (int i = 0; i < volume.grid.size[0]; ++i, ++v) {
        const Eigen::Vector3d p =
            (volume.grid.toMri({double(i), double(j), double(k)}).mm - centre) / kHead_mm;
        volume.voxels[v] *= float(std::exp(bias * std::clamp(field(p), -1.5, 1.5)));
      }
}

void addNoise(Volume& volume, const Mask& brain, const VolumePerturbation& p, std::mt19937& random) {
  const float scale = volume::percentile(volume, 0.98);
  std::normal_distribution<float> normal;
  std::vector<float> outside;
  if (p.scalp_noise > 0) outside = volume::distanceTo(volume::resample(brain, volume.grid));
  for (std::size_t v = 0; v < volume.voxels.size(); ++v) {
    const bool is_scalp = !outside.empty() && outside[v] > kScalpFrom_mm;
    const float sigma = scale * float(std::hypot(p.noise, is_scalp ? p.scalp_noise : 0.0));
    if (sigma > 0)
      volume.voxels[v] = std::hypot(volume.voxels[v] + sigma * normal(random), sigma * normal(random));
  }
}

}  // namespace

std::vector<VolumePerturbation> standardPerturbations() {
  using P = VolumePerturbation;
  std::vector<P> all;
  for (int axis = 0; axis < 3; ++axis)
    for (double deg : {-20.0, 20.0}) all.push_back(turned(axis, deg));
  for (const auto& [name, spacing] :
       {std::pair{"0.5 mm", 0.5}, {"0.75 mm", 0.75}, {"1.25 mm", 1.25}, {"1.5 mm", 1.5}})
    all.push_back(with(name, &P::spacing_mm, spacing));
  all.push_back(with("values x 0.02", &P::gain, 0.02));
  all.push_back(with("values x 50", &P::gain, 50.0));
  all.push_back(with("noise 3 %", &P::noise, 0.03));
  all.push_back(with("noise 6 %", &P::noise, 0.06));
  all.push_back(with("bias 20 %", &P::bias, 0.2));
  all.push_back(with("bias 40 %", &P::bias, 0.4));
  return all;
}

std::vector<VolumePerturbation> hardHeads() {
  using P = VolumePerturbation;
  std::vector<P> all{with("neck 100 mm longer", &P::neck_mm, 100.0),
                     with("child (0.85)", &P::size, 0.85),
                     with("big (1.1)", &P::size, 1.1),
                     with("low contrast", &P::gamma, 0.55),
                     with("high contrast", &P::gamma, 1.6),
                     with("bias 70 %", &P::bias, 0.7),
                     with("noise 10 %", &P::noise, 0.1),
                     with("noisy scalp", &P::scalp_noise, 0.2)};
  P bad;
  bad.name = "child, neck, low contrast, bias 40 %, noise 5 %, scalp 10 %";
  bad.size = 0.85, bad.neck_mm = 60, bad.gamma = 0.7, bad.bias = 0.4, bad.noise = 0.05, bad.scalp_noise = 0.1;
  all.push_back(bad);
  return all;
}

Volume perturbed(const Volume& volume, const Mask& brain, const VolumePerturbation& p, unsigned seed) {
  std::mt19937 random(seed);
  const Eigen::Affine3d move = movedFromOriginal(volume.grid, p);
  Volume out = p.neck_mm > 0 ? withNeck(volume, p.neck_mm) : volume;
  Mask moved_brain = brain;
  out.grid.mri_from_voxel = move * out.grid.mri_from_voxel;
  moved_brain.grid.mri_from_voxel = move * moved_brain.grid.mri_from_voxel;
  if (p.spacing_mm > 0) out = resampledTo(out, p.spacing_mm);
  if (p.gamma != 1) {
    const float top = std::max(1e-6f, volume::percentile(out, 0.99));
    for (float& v : out.voxels) v = top * std::pow(std::max(0.f, v) / top, float(p.gamma));
  }
  if (p.bias > 0) addBias(out, p.bias, random);
  if (p.noise > 0 || p.scalp_noise > 0) addNoise(out, moved_brain, p, random);
  for (float& v : out.voxels) v *= float(p.gain);
  return out;
}

Mask unperturbed(const Mask& mask, const VoxelGrid& original, const VolumePerturbation& p) {
  Mask back = mask;
  back.grid.mri_from_voxel = movedFromOriginal(original, p).inverse() * back.grid.mri_from_voxel;
  return back.grid.matches(original) ? back : volume::resample(back, original);
}

Point<Mri> unperturbed(const Point<Mri>& place, const VoxelGrid& original, const VolumePerturbation& p) {
  return Point<Mri>(movedFromOriginal(original, p).inverse() * place.mm);
}

}  // namespace facenav::evaluation
