#include "scan_sharpness.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "brain_start.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/smoothing.h"

// The point spread measured in an image, on images with a known one: steps between grey and white matter
// along curved surfaces, blurred by kernels of known variance.

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr int kEdge = 64;  // voxels of 1 mm

TissueModel model() {
  TissueModel tissue;
  tissue.fluid = {30, 5, 0.1}, tissue.grey = {70, 5, 0.4}, tissue.white = {100, 5, 0.5};
  return tissue;
}

/// White matter with bodies of grey matter, each voxel the mean of its cube (4^3 samples). Made once.
const Volume& steps() {
  static const Volume made = [] {
    constexpr int kFine = 4;
    std::array<std::vector<double>, 3> wave;
    for (int n = 0; n < kEdge * kFine; ++n)
      for (int a = 0; a < 3; ++a) wave[a].push_back(std::sin(n / double(kFine) / (7 + a)));
    Volume image;
    image.grid.size = {kEdge, kEdge, kEdge};
    image.voxels.assign(image.grid.count(), 100);
    for (int k = 0; k < kEdge * kFine; ++k)
      for (int j = 0; j < kEdge * kFine; ++j)
        for (int i = 0; i < kEdge * kFine; ++i)
          if (wave[0][i] + wave[1][j] + wave[2][k] > 1.2)
            image.voxels[image.grid.index(i / kFine, j / kFine, k / kFine)] -= 30.f / (kFine * kFine * kFine);
    return image;
  }();
  return made;
}

Mask inside(const Volume& image) { return ballOf(image.grid, Eigen::Vector3d::Constant(kEdge / 2.0), 27); }

Volume blurred(Volume image, double variance_mm2) {
  return volume::spread(std::move(image), Eigen::Vector3d::Constant(variance_mm2));
}

void addNoise(Volume& image, float sigma) {
  std::mt19937 random(5);
  std::normal_distribution<float> normal(0, sigma);
  for (float& value : image.voxels) value += normal(random);
}

TEST(ScanSharpness, MeasuresHowMuchMoreOneImageIsBlurredThanAnother) {
  const Mask core = inside(steps());
  const double least = pointSpread_mm2(blurred(steps(), 0.2), core, model());
  for (const double more : {0.1, 0.2, 0.3})
    EXPECT_NEAR(pointSpread_mm2(blurred(steps(), 0.2 + more), core, model()) - least, more, 0.15 * more);
}

TEST(ScanSharpness, DoesNotTakeNoiseForSharpness) {
  Volume image = blurred(steps(), 0.35);
  const Mask core = inside(image);
  const double quiet = pointSpread_mm2(image, core, model());
  addNoise(image, 4);
  EXPECT_NEAR(pointSpread_mm2(image, core, model()), quiet, 0.06);
}

TEST(ScanSharpness, BringsSharpAndBlurredImagesTogether) {
  const Volume sharp = blurred(steps(), 0.1), soft = blurred(sharp, 0.3);
  const Mask core = inside(sharp);
  const Volume a = atCommonSharpness(sharp, sharp.grid, core, model()),
               b = atCommonSharpness(soft, sharp.grid, core, model());
  double before = 0, after = 0;
  for (std::size_t v = 0; v < core.voxels.size(); ++v) {
    if (!core.voxels[v]) continue;
    before += std::pow(sharp.voxels[v] - soft.voxels[v], 2);
    after += std::pow(a.voxels[v] - b.voxels[v], 2);
  }
  EXPECT_LT(after, before / 9);
}

TEST(ScanSharpness, LeavesAnImageWithoutStepsAsItIs) {
  Volume flat = steps();
  for (float& value : flat.voxels) value = 100;
  EXPECT_EQ(pointSpread_mm2(flat, inside(flat), model()), 0);
  EXPECT_EQ(atCommonSharpness(flat, flat.grid, inside(flat), model()).voxels, flat.voxels);
}

}  // namespace
}  // namespace facenav::segmentation
