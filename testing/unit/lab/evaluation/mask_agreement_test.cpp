#include "facenav/evaluation/mask_agreement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/evaluation/mask_table.h"
#include "facenav/evaluation/volume_perturbation.h"

namespace facenav::evaluation {
namespace {

using volume::Mask;

Mask emptyMask(int n, double spacing_mm = 1) {
  Mask mask;
  mask.grid.size = {n, n, n};
  mask.grid.mri_from_voxel.linear() *= spacing_mm;
  mask.voxels.assign(mask.grid.count(), 0);
  return mask;
}

/// Mask of voxels low..high along each axis.
Mask box(const Eigen::Array3i& low, const Eigen::Array3i& high, double spacing_mm = 1) {
  Mask mask = emptyMask(32, spacing_mm);
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) mask.voxels[mask.grid.index(i, j, k)] = 1;
  return mask;
}

TEST(MaskAgreement, OfAShiftedBoxIsKnownByHand) {
  const Mask a = box({8, 8, 8}, {17, 17, 17}, 2), b = box({11, 8, 8}, {20, 17, 17}, 2);
  const auto agreement = compareMasks(a, b);
  EXPECT_DOUBLE_EQ(agreement.dice, 0.7);
  EXPECT_DOUBLE_EQ(agreement.inside, 0.7);
  EXPECT_DOUBLE_EQ(agreement.hausdorff95_mm, 6);  // one face of ten by ten voxels, three steps of 2 mm away
  EXPECT_DOUBLE_EQ(agreement.found_ml, 8);
  const auto same = compareMasks(a, a);
  EXPECT_EQ(same.dice, 1);
  EXPECT_EQ(same.hausdorff95_mm, 0);
}

TEST(MaskAgreement, HausdorffIsTheLargerOfBothDirections) {
  Mask thorn = box({8, 8, 8}, {15, 15, 15});
  for (int i = 16; i < 30; ++i)  // a spike of 5 x 5 voxels: 280 of its 592 surface voxels
    for (int j = 9; j < 14; ++j)
      for (int k = 9; k < 14; ++k) thorn.voxels[thorn.grid.index(i, j, k)] = 1;
  const Mask plain = box({8, 8, 8}, {15, 15, 15});
  const double forth = compareMasks(thorn, plain).hausdorff95_mm,
               back = compareMasks(plain, thorn).hausdorff95_mm;
  EXPECT_EQ(forth, back);
  EXPECT_GT(forth, 10);
}

TEST(MaskAgreement, RefusesAnEmptyMask) {
  EXPECT_THROW(compareMasks(emptyMask(32), box({8, 8, 8}, {9, 9, 9})), Error);
}

TEST(MaskAgreement, ClosingBridgesASulcusAndFillsAVentricle) {
  Mask tissue = box({0, 8, 8}, {20, 20, 20});  // reaches the grid's edge
  const Mask whole = tissue;
  for (int k = 12; k <= 20; ++k)
    for (int j = 8; j <= 20; ++j)
      for (int i = 9; i <= 11; ++i) tissue.voxels[tissue.grid.index(i, j, k)] = 0;  // 3 voxels wide
  tissue.voxels[tissue.grid.index(5, 14, 14)] = 0;
  const Mask closed = closedAndFilled(tissue, 2);
  EXPECT_TRUE(closed.at(10, 14, 14));
  EXPECT_TRUE(closed.at(5, 14, 14));
  EXPECT_EQ(volume::overlap(tissue, closed).inside, 1);  // removes nothing
  EXPECT_EQ(volume::overlap(closed, whole).inside, 1);   // adds nothing beyond the box
  const Mask open = closedAndFilled(tissue, 1);
  EXPECT_FALSE(open.at(10, 14, 17));
}

volume::Volume ramp() {
  volume::Volume volume;
  volume.grid.size = {24, 24, 24};
  for (int v = 0; v < 24 * 24 * 24; ++v) volume.voxels.push_back(float(v % 24 + 10));
  return volume;
}

VolumePerturbation named(const std::string& name) {
  for (const auto& all : {standardPerturbations(), hardHeads()})
    for (const auto& perturbation : all)
      if (perturbation.name.rfind(name, 0) == 0) return perturbation;
  throw std::runtime_error("no perturbation " + name);
}

Mask noBrain(const volume::Volume& volume) {
  return {volume.grid, std::vector<std::uint8_t>(volume.grid.count())};
}

TEST(VolumePerturbation, ATurnMovesTheWorldAndTheMaskComesBack) {
  const auto volume = ramp();
  const auto turn = named("turned +20 deg about x");
  const auto other = perturbed(volume, noBrain(volume), turn, 1);
  EXPECT_EQ(other.voxels, volume.voxels);
  const Eigen::Vector3d up = other.grid.mri_from_voxel.linear() * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(std::atan2(-up.y(), up.z()), 20 * M_PI / 180, 1e-9);
  EXPECT_TRUE(other.grid.centre().mm.isApprox(volume.grid.centre().mm));
  Mask mask = noBrain(other);
  mask.voxels[mask.grid.index(3, 4, 5)] = 1;
  const Mask back = unperturbed(mask, volume.grid, turn);
  EXPECT_TRUE(back.grid.matches(volume.grid));
  EXPECT_EQ(back.voxels, mask.voxels);
}

TEST(VolumePerturbation, CoarserVoxelsAreMeansAndTheMaskComesBack) {
  const auto volume = ramp();
  const auto coarse = named("1.5 mm");
  const auto other = perturbed(volume, noBrain(volume), coarse, 1);
  EXPECT_NEAR(other.grid.spacing_mm().x(), 1.5, 1e-9);
  EXPECT_NEAR(other.at(4, 8, 8), 16, 1e-3);  // the ramp's value at x = 6 mm
  Mask all{other.grid, std::vector<std::uint8_t>(other.grid.count(), 1)};
  EXPECT_TRUE(unperturbed(all, volume.grid, coarse).at(12, 12, 12));
}

TEST(VolumePerturbation, NoiseIsRicianOfTheStatedSizeAndTheSameForASeed) {
  volume::Volume flat = ramp();
  std::fill(flat.voxels.begin(), flat.voxels.end(), 100.f);
  const auto noisy = perturbed(flat, noBrain(flat), named("noise 6 %"), 5);
  double sum = 0, squares = 0;
  for (float v : noisy.voxels) sum += v, squares += double(v) * v;
  const double n = double(noisy.voxels.size()), mean = sum / n;
  EXPECT_NEAR(std::sqrt(squares / n - mean * mean), 6, 0.15);
  EXPECT_NEAR(squares / n, 100 * 100 + 2 * 36, 20);  // Rician second moment
  EXPECT_EQ(perturbed(flat, noBrain(flat), named("noise 6 %"), 5).voxels, noisy.voxels);
}

TEST(VolumePerturbation, TheNeckGrowsDownwards) {
  const auto volume = ramp();
  const auto longer = perturbed(volume, noBrain(volume), named("neck 100 mm"), 1);
  EXPECT_EQ(longer.grid.size[2], 124);
  EXPECT_NEAR(longer.grid.toMri({0, 0, 0}).mm.z(), -100, 1e-9);
  EXPECT_EQ(longer.at(7, 3, 0), volume.at(7, 3, 0));
}

TEST(MaskTable, SaysWhatWasNotMeasuredAndQuotesCommas) {
  MaskRow row;
  row.volume = "head, left.nii", row.method = "bet", row.failure = "no brain";
  EXPECT_NE(maskCsv({row}).find("\"head, left.nii\",,bet,,,,,"), std::string::npos) << maskCsv({row});
  EXPECT_NE(maskMarkdown({row}).find("| head, left.nii | - | bet | - | - | - | - | - |"), std::string::npos)
      << maskMarkdown({row});
}

TEST(MaskTable, SummaryCountsARefusalAsNothingFound) {
  std::vector<MaskRow> rows(3);
  for (auto& row : rows) row.method = "brain";
  rows[0].agreement = MaskAgreement{0.9}, rows[1].agreement = MaskAgreement{0.97};
  rows[2].failure = "no brain can be modelled";
  EXPECT_NE(maskSummaryMarkdown(rows).find("| brain | 3 | 1 | 0.9000 | 0.9000 |"), std::string::npos)
      << maskSummaryMarkdown(rows);
}

}  // namespace
}  // namespace facenav::evaluation
