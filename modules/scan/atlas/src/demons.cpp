#include "demons.h"

#include <Eigen/LU>
#include <algorithm>

namespace facenav::atlas {
namespace {

constexpr float kLongestStep = 0.5f;  // nodes
constexpr int kFluidPasses = 4;       // each update is smoothed: variance 8/3 nodes^2
constexpr int kElasticPasses = 1;     // the sum is smoothed: variance 2/3 nodes^2

/// Efficient second-order force: uses the mean of both images' gradients; the step is limited to
/// kLongestStep.
Eigen::Vector3f force(const ScalarField& fixed, const ScalarField& moving, std::size_t n, int i, int j, int k,
                      float weight, float& denominator) {
  const float difference = fixed.values[n] - moving.values[n];
  const Eigen::Vector3f slope = 0.5f * (gradientAt(fixed, i, j, k) + gradientAt(moving, i, j, k));
  constexpr float kBound = 1.f / (4.f * kLongestStep * kLongestStep);  // |u| <= 1 / (2 sqrt(kBound))
  denominator += weight * (slope.squaredNorm() + kBound * difference * difference);
  return weight * difference * slope;
}

VectorField update(const BrainPair& pair, const Channels& moving) {
  const auto& fixed = pair.fixed();
  VectorField u = noDisplacement(pair.grid().size);
  forSlices(pair.grid().size[2], [&](int k) {
    for (int j = 0; j < pair.grid().size[1]; ++j)
      for (int i = 0; i < pair.grid().size[0]; ++i) {
        const std::size_t n = u[0].index(i, j, k);
        float denominator = 1e-6f;
        Eigen::Vector3f sum = force(fixed.brain, moving.brain, n, i, j, k, kBrainWeight, denominator);
        if (fixed.t1.values[n] != 0 && moving.t1.values[n] != 0)
          sum += force(fixed.t1, moving.t1, n, i, j, k, 1.f, denominator);
        sum /= denominator;
        for (int a = 0; a < 3; ++a) u[a].values[n] = sum[a];
      }
  });
  return u;
}

/// Composition: (d o u)(x) = u(x) + d(x + u(x)).
VectorField composed(const VectorField& d, const VectorField& u) {
  VectorField sum = noDisplacement(d[0].size);
  forSlices(d[0].size[2], [&](int k) {
    for (int j = 0; j < d[0].size[1]; ++j)
      for (int i = 0; i < d[0].size[0]; ++i) {
        const std::size_t n = d[0].index(i, j, k);
        const Eigen::Vector3f step(u[0].values[n], u[1].values[n], u[2].values[n]);
        const Eigen::Vector3f at = Eigen::Vector3f(float(i), float(j), float(k)) + step;
        const Cell cell(d[0].size, at);
        for (int a = 0; a < 3; ++a) sum[a].values[n] = step[a] + cell.of(d[a]);
      }
  });
  return sum;
}

void smooth(VectorField& field, int passes) {
  for (auto& component : field) component = smoothed(std::move(component), passes);
}

}  // namespace

VectorField noDisplacement(const std::array<int, 3>& size) {
  return {ScalarField(size), ScalarField(size), ScalarField(size)};
}

VectorField onGrid(const VectorField& displacement, const volume::VoxelGrid& from,
                   const volume::VoxelGrid& to) {
  const Eigen::Affine3f from_to = (from.mri_from_voxel.inverse() * to.mri_from_voxel).cast<float>();
  const float scale = float(from.spacing_mm()[0] / to.spacing_mm()[0]);
  VectorField result = noDisplacement(to.size);
  forSlices(to.size[2], [&](int k) {
    for (int j = 0; j < to.size[1]; ++j)
      for (int i = 0; i < to.size[0]; ++i) {
        const Eigen::Vector3f at = from_to * Eigen::Vector3f(float(i), float(j), float(k));
        for (int a = 0; a < 3; ++a)
          result[a].values[result[a].index(i, j, k)] = scale * sample(displacement[a], at);
      }
  });
  return result;
}

VectorField runDemons(const BrainPair& pair, const Eigen::Affine3d& mri_from_mni, VectorField displacement,
                      int iterations, const std::function<void(double)>& on_progress) {
  for (int i = 0; i < iterations; ++i) {
    on_progress(double(i) / iterations);
    VectorField u = update(pair, pair.warped(mri_from_mni, &displacement));
    smooth(u, kFluidPasses);
    displacement = composed(displacement, u);
    smooth(displacement, kElasticPasses);
  }
  return displacement;
}

double smallestJacobian(const VectorField& d) {
  double smallest = HUGE_VAL;
  for (int k = 1; k + 1 < d[0].size[2]; ++k)
    for (int j = 1; j + 1 < d[0].size[1]; ++j)
      for (int i = 1; i + 1 < d[0].size[0]; ++i) {
        Eigen::Matrix3f jacobian = Eigen::Matrix3f::Identity();
        for (int a = 0; a < 3; ++a) jacobian.row(a) += gradientAt(d[a], i, j, k).transpose();
        smallest = std::min(smallest, double(jacobian.determinant()));
      }
  return smallest;
}

}  // namespace facenav::atlas
