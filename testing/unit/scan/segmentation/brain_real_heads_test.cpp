#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "facenav/evaluation/volume_perturbation.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"
#include "support/test_data.h"

// Brain masks of real heads: Colin27's against the mask of an independent network; and the same head in other
// scans.

namespace facenav {
namespace {

volume::Mask brainOf(const volume::Volume& volume) {
  TaskMonitor monitor;
  return segmentation::makeBrainSegmenter()->segment(volume, monitor).mask;
}

/// Mask of Colin27's brain, found once for all tests.
const volume::Mask& brainOfColin27() {
  static const volume::Mask brain = brainOf(volume::readNifti(testing::colin27()).volume);
  return brain;
}

TEST(BrainOfRealHead, AgreesWithColin27sBrain) {
  FACENAV_NEEDS(testing::colin27());
  const auto truth = volume::readMask(testing::colin27Brain());
  // ch2bet leaves the sulci open: half the brain's surface. Bare overlap is enough here: all of it lies
  // inside.
  const auto& found = brainOfColin27();
  EXPECT_GE(volume::overlap(truth, found).inside, 0.975);
  EXPECT_NEAR(found.volume_ml(), 1768, 50);  // ch2bet closed by 2 voxels and filled
}

TEST(BrainOfRealHead, HoldsStillUnderNoise) {
  FACENAV_NEEDS(testing::colin27());
  auto noisy = volume::readNifti(testing::colin27()).volume;
  const float sigma = 0.06f * volume::percentile(noisy, 0.98);
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  for (float& v : noisy.voxels) v = std::hypot(v + sigma * normal(random), sigma * normal(random));
  EXPECT_GE(volume::overlap(brainOf(noisy), brainOfColin27()).dice, 0.99);
}

const volume::Mask& brainOfPatient() {
  static const volume::Mask brain = brainOf(volume::readNifti(testing::virtualPatientMri()).volume);
  return brain;
}

TEST(BrainOfRealHead, LiesInsideTheMaskWithFluidOfAWholeHead) {
  FACENAV_NEEDS(testing::virtualPatientMri());
  const auto reference = testing::sharedData() / "masks/brainbrowser_structural1_with_csf.nii.gz";
  FACENAV_NEEDS(reference);
  const auto& found = brainOfPatient();
  const auto overlap = volume::overlap(found, volume::resample(volume::readMask(reference), found.grid));
  EXPECT_GE(overlap.inside, 0.985);
  EXPECT_GE(overlap.dice, 0.92);
}

/// Checks the coil's region, where the sagittal sinus and the skull's marrow touch the crowns.
TEST(BrainOfRealHead, LeavesOutSinusAndMarrowAtTheVertex) {
  FACENAV_NEEDS(testing::virtualPatientMri());
  const auto reference = testing::sharedData() / "masks/brainbrowser_structural1_with_csf.nii.gz";
  FACENAV_NEEDS(reference);
  const auto& found = brainOfPatient();
  const auto with_fluid = volume::resample(volume::readMask(reference), found.grid);
  constexpr double kTop_mm = 15;
  double vertex_mm = -1e9;
  std::vector<std::pair<double, bool>> seen;  // height of each voxel found, and whether it may be brain
  std::size_t at = 0;
  for (int k = 0; k < found.grid.size[2]; ++k)
    for (int j = 0; j < found.grid.size[1]; ++j)
      for (int i = 0; i < found.grid.size[0]; ++i, ++at) {
        const double z_mm = found.grid.toMri({double(i), double(j), double(k)}).mm.z();
        if (with_fluid.voxels[at]) vertex_mm = std::max(vertex_mm, z_mm);
        if (found.voxels[at]) seen.emplace_back(z_mm, with_fluid.voxels[at]);
      }
  double count = 0, inside = 0;
  for (const auto& [z_mm, is_inside] : seen)
    if (z_mm > vertex_mm - kTop_mm) ++count, inside += is_inside;
  EXPECT_GT(count, 20000);
  EXPECT_GE(inside / count, 0.99);
}

/// Change of the mask (1 - Dice) when the scan is perturbed by `name`.
double movedBy(const std::string& name, const volume::Volume& head, const volume::Mask& brain) {
  for (const auto& perturbation : evaluation::standardPerturbations())
    if (perturbation.name == name) {
      const auto other = brainOf(evaluation::perturbed(head, brain, perturbation, 1));
      return 1 - volume::overlap(evaluation::unperturbed(other, head.grid, perturbation), brain).dice;
    }
  throw std::invalid_argument("no perturbation is named " + name);
}

TEST(BrainOfRealHead, HoldsStillInCoarserVoxels) {
  FACENAV_NEEDS(testing::virtualPatientMri());
  const auto head = volume::readNifti(testing::virtualPatientMri()).volume;
  EXPECT_LE(movedBy("1.25 mm", head, brainOfPatient()), 0.01);
  EXPECT_LE(movedBy("1.5 mm", head, brainOfPatient()), 0.01);
}

TEST(BrainOfRealHead, HoldsStillUnderABlurThatTheVoxelsSizeDoesNotSay) {
  FACENAV_NEEDS(testing::virtualPatientMri());
  const auto head = volume::readNifti(testing::virtualPatientMri()).volume;
  const auto blurred = volume::spread(head, Eigen::Vector3d::Constant(0.3));  // as two interpolations do
  EXPECT_GE(volume::overlap(brainOf(blurred), brainOfPatient()).dice, 0.99);
}

}  // namespace
}  // namespace facenav
