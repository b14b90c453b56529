#include "facenav/prepare/correct_brain.h"

#include <gmock/gmock.h>

#include <cstring>

#include "facenav/casefile/edited_brain.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/nifti.h"
#include "support/ball_case.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A ball of 90 mm with a brain of 40 mm on a grid of 4 mm, signed off.
class CorrectBrain : public ::testing::Test {
 protected:
  CorrectBrain()
      : store_(casefile::CaseStore::create(folder_.path() / "case", facenav::testing::ballWithBrain(), {},
                                           false)),
        prepared_(*store_.brainMask()) {
    casefile::signOff(store_, {"XY", "", true});
  }
  CorrectedBrain correct(const BrainEdits& edits) { return correctBrain(store_, edits, monitor_); }
  bool isBrain(double x_mm, double y_mm, double z_mm) const {
    const auto mask = *store_.brainMask();
    const Eigen::Vector3d v = mask.grid.toVoxel(Point<Mri>(x_mm, y_mm, z_mm));
    return mask.at(int(std::lround(v.x())), int(std::lround(v.y())), int(std::lround(v.z())));
  }
  facenav::testing::TemporaryFolder folder_;
  TaskMonitor monitor_;
  casefile::CaseStore store_;
  volume::Mask prepared_;
};

TEST_F(CorrectBrain, SpheresAddAndRemoveAndTheSurfacesFollow) {
  const auto before = store_.brain()->mesh.vertices_mm;
  BrainEdits edits;
  edits.added = {{Point<Mri>(42, 2, 2), 10}};
  edits.removed = {{Point<Mri>(-38, 2, 2), 8}};
  const auto result = correct(edits);
  EXPECT_TRUE(isBrain(50, 2, 2));
  EXPECT_FALSE(isBrain(-38, 2, 2));
  EXPECT_GT(result.added_voxels, 20u);
  EXPECT_GT(result.removed_voxels, 10u);
  EXPECT_NEAR(result.after_ml - result.before_ml,
              0.064 * (double(result.added_voxels) - double(result.removed_voxels)), 1e-9);
  EXPECT_EQ(casefile::automaticBrainMask(store_)->voxels, prepared_.voxels);
  EXPECT_FALSE(casefile::validSignOff(store_));
  double most_mm = 0;
  const auto brain = store_.brain();
  for (const auto& v : brain->mesh.vertices_mm) most_mm = std::max(most_mm, v.x());
  EXPECT_NEAR(most_mm, 52.0, 4.0);
  EXPECT_NE(brain->mesh.vertices_mm, before);
  EXPECT_TRUE(store_.cortex().has_value());
  EXPECT_TRUE(std::filesystem::exists(store_.folder() / "surface_distance.png"));
}

TEST_F(CorrectBrain, AMaskDrawnElsewhereIsTakenOnTheScansOwnGridOnly) {
  auto drawn = prepared_;
  drawn.voxels[drawn.grid.index(40, 25, 25)] = 1;
  volume::writeMask(drawn, folder_.path() / "drawn.nii.gz");
  BrainEdits edits;
  edits.drawn = folder_.path() / "drawn.nii.gz";
  EXPECT_EQ(correct(edits).added_voxels, 1u);
  EXPECT_EQ(store_.brainMask()->voxels, drawn.voxels);
  drawn.grid.mri_from_voxel.translation().x() += 1;
  volume::writeMask(drawn, folder_.path() / "drawn.nii.gz");
  EXPECT_THAT([&] { correct(edits); }, ThrowsMessage<Error>(HasSubstr("another grid")));
}

/// The mask's two maps to world, of which one lies 5 mm aside.
std::filesystem::path withMapAside(const std::filesystem::path& path, const volume::Mask& mask,
                                   bool is_sform) {
  volume::writeMask(mask, path);
  std::string bytes = readWholeFile(path);
  constexpr std::size_t kQoffsetX = 268, kSrowX3 = 292;
  float x_mm = 0;
  std::memcpy(&x_mm, &bytes[is_sform ? kSrowX3 : kQoffsetX], sizeof x_mm);
  x_mm += 5;
  std::memcpy(&bytes[is_sform ? kSrowX3 : kQoffsetX], &x_mm, sizeof x_mm);
  writeWholeFile(path, bytes);
  return path;
}

TEST_F(CorrectBrain, ADrawnMaskWhoseMapsDisagreeIsSaidByMillimetres) {
  auto drawn = prepared_;
  drawn.voxels[drawn.grid.index(40, 25, 25)] = 1;
  BrainEdits edits;
  edits.drawn = withMapAside(folder_.path() / "q.nii", drawn, false);
  const auto result = correct(edits);
  EXPECT_EQ(result.added_voxels, 1u);
  EXPECT_THAT(result.notes, ::testing::ElementsAre(HasSubstr("disagree by up to 5.0 mm; the sform is used")));
  edits.drawn = withMapAside(folder_.path() / "s.nii", drawn, true);
  EXPECT_THAT([&] { correct(edits); },
              ThrowsMessage<Error>(HasSubstr("5.0 mm beside the scan by its sform; by its qform it fits")));
}

TEST_F(CorrectBrain, ADrawnMaskMayOrderItsAxesOtherwise) {
  auto drawn = prepared_;
  drawn.voxels[drawn.grid.index(40, 25, 20)] = 1;
  auto flipped = drawn;
  const auto& size = drawn.grid.size;
  flipped.grid.size = {size[2], size[1], size[0]};
  Eigen::Affine3d drawn_from_flipped = Eigen::Affine3d::Identity();
  drawn_from_flipped.linear() << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  drawn_from_flipped.translation().x() = size[0] - 1;
  flipped.grid.mri_from_voxel = drawn.grid.mri_from_voxel * drawn_from_flipped;
  for (int k = 0; k < size[0]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[2]; ++i)
        flipped.voxels[flipped.grid.index(i, j, k)] = drawn.at(size[0] - 1 - k, j, i);
  volume::writeMask(flipped, folder_.path() / "drawn.nii.gz");
  BrainEdits edits;
  edits.drawn = folder_.path() / "drawn.nii.gz";
  EXPECT_EQ(correct(edits).added_voxels, 1u);
  EXPECT_EQ(store_.brainMask()->voxels, drawn.voxels);
}

TEST_F(CorrectBrain, BackToTheAutomaticMask) {
  BrainEdits edits;
  edits.added = {{Point<Mri>(42, 2, 2), 10}};
  correct(edits);
  BrainEdits back;
  back.starts_automatic = true;
  EXPECT_GT(correct(back).removed_voxels, 20u);
  EXPECT_EQ(store_.brainMask()->voxels, prepared_.voxels);
}

TEST_F(CorrectBrain, WhatChangesNothingWritesNothing) {
  BrainEdits edits;
  edits.added = {{Point<Mri>(2, 2, 2), 5}};  // already brain
  EXPECT_FALSE(correct(edits).isChanged());
  EXPECT_TRUE(casefile::validSignOff(store_)) << "the sign-off must hold";
  EXPECT_FALSE(casefile::hasEditedBrainMask(store_));
}

TEST_F(CorrectBrain, GoesOnFromADraftUnlessItIsDiscarded) {
  auto draft = prepared_;
  draft.voxels[draft.grid.index(40, 25, 25)] = 1;
  casefile::saveBrainDraft(store_, draft);
  BrainEdits edits;
  edits.added = {{Point<Mri>(42, 2, 2), 10}};
  edits.discards_draft = true;
  EXPECT_FALSE(correct(edits).had_draft);
  EXPECT_FALSE(store_.brainMask()->at(40, 25, 25));
  casefile::saveBrainDraft(store_, draft);
  edits.discards_draft = false;
  EXPECT_TRUE(correct(edits).had_draft);
  EXPECT_TRUE(store_.brainMask()->at(40, 25, 25));
  EXPECT_FALSE(casefile::brainDraft(store_)) << "it is in force now";
}

TEST_F(CorrectBrain, SavingAMaskKeepsADraftThatMayBeNewer) {
  auto saved = prepared_, newer = prepared_;
  saved.voxels[saved.grid.index(40, 25, 25)] = 1;
  newer.voxels[newer.grid.index(41, 25, 25)] = 1;
  casefile::saveBrainDraft(store_, newer);
  saveCorrection(store_, store_.mri(), saved, monitor_);
  EXPECT_EQ(store_.brainMask()->voxels, saved.voxels);
  ASSERT_TRUE(casefile::hasBrainDraft(store_));
  EXPECT_EQ(casefile::brainDraft(store_)->voxels, newer.voxels);
}

TEST_F(CorrectBrain, HolesAreFilledAndRefusalsWriteNothing) {
  BrainEdits hollow;
  hollow.removed = {{Point<Mri>(2, 2, 2), 10}};
  correct(hollow);
  BrainEdits fill;
  fill.fills_holes = true;
  EXPECT_EQ(correct(fill).removed_voxels, 0u);
  EXPECT_EQ(store_.brainMask()->voxels, prepared_.voxels);
  BrainEdits outside;
  outside.added = {{Point<Mri>(300, 0, 0), 5}};
  EXPECT_THAT([&] { correct(outside); }, ThrowsMessage<Error>(HasSubstr("outside the scan")));
  EXPECT_EQ(store_.brainMask()->voxels, prepared_.voxels);
}

TEST(CorrectBrainWithoutOne, IsRefused) {
  const facenav::testing::TemporaryFolder folder;
  const auto store =
      casefile::CaseStore::create(folder.path() / "case", facenav::testing::ballCase(), {}, false);
  TaskMonitor monitor;
  BrainEdits edits;
  edits.fills_holes = true;
  EXPECT_THAT([&] { correctBrain(store, edits, monitor); }, ThrowsMessage<Error>(HasSubstr("no brain mask")));
}

}  // namespace
}  // namespace facenav::steps
