#include "facenav/casefile/edited_brain.h"

#include <gtest/gtest.h>

#include "facenav/casefile/sign_off.h"
#include "facenav/core/error.h"
#include "made_case.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

using facenav::testing::TemporaryFolder;
using testing::preparedCase;
namespace fs = std::filesystem;

struct MadeCase {
  TemporaryFolder folder;
  CaseStore store = CaseStore::create(folder.path() / "case", preparedCase(), {}, false);
};

volume::Mask corrected(const CaseStore& store, std::size_t voxel) {
  volume::Mask mask = store.brainMask().value();
  mask.voxels[voxel] ^= 1;
  return mask;
}

TEST(EditedBrain, IsInForceAndTheAutomaticMaskStaysAtHand) {
  const MadeCase made;
  const auto automatic = made.store.brainMask().value();
  EXPECT_FALSE(hasEditedBrainMask(made.store));
  EXPECT_EQ(automaticBrainMask(made.store)->voxels, automatic.voxels);
  for (std::size_t voxel : {100u, 200u}) {  // the second correction must not overwrite the automatic mask
    const auto mask = corrected(made.store, voxel);
    saveEditedBrainMask(made.store, mask);
    EXPECT_TRUE(hasEditedBrainMask(made.store));
    EXPECT_EQ(CaseStore::open(made.store.folder()).brainMask()->voxels, mask.voxels);
    EXPECT_EQ(automaticBrainMask(made.store)->voxels, automatic.voxels);
  }
  for (const char* name : {"brain_mask.nii.gz", "brain_mask_auto.nii.gz"})
    EXPECT_EQ(fs::status(made.store.folder() / name).permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
  revertToAutomaticBrainMask(made.store);
  EXPECT_FALSE(hasEditedBrainMask(made.store));
  EXPECT_EQ(made.store.brainMask()->voxels, automatic.voxels);
  revertToAutomaticBrainMask(made.store);
}

TEST(EditedBrain, RefusesAMaskOfAnotherScanAndACaseWithoutABrain) {
  const MadeCase made;
  auto mask = made.store.brainMask().value();
  mask.grid.mri_from_voxel.translation().x() += 1;
  EXPECT_THROW(saveEditedBrainMask(made.store, mask), Error);
  EXPECT_FALSE(hasEditedBrainMask(made.store));
  PreparedCase without = preparedCase();
  without.brain_mask.reset(), without.brain.reset();
  const auto store = CaseStore::create(made.folder.path() / "without", without, {}, false);
  EXPECT_THROW(saveEditedBrainMask(store, preparedCase().brain_mask.value()), Error);
  EXPECT_FALSE(automaticBrainMask(store));
}

TEST(EditedBrain, ACorrectionMakesTheSignOffVoid) {
  const MadeCase made;
  signOff(made.store, {"A. B.", "", true});
  EXPECT_TRUE(validSignOff(made.store));
  saveEditedBrainMask(made.store, corrected(made.store, 100));
  EXPECT_FALSE(validSignOff(made.store));
}

TEST(EditedBrain, TheModelIsWrittenAnew) {
  const MadeCase made;
  auto brain = made.store.brain().value();
  brain.mesh.vertices_mm[0].x() += 3;
  saveBrainModel(made.store, brain);
  EXPECT_NEAR(made.store.brain()->mesh.vertices_mm[0].x(), brain.mesh.vertices_mm[0].x(), 1e-3);
}

TEST(EditedBrain, TheCortexOfAnotherMaskDoesNotStay) {
  const MadeCase made;
  const auto brain = made.store.brain().value();
  EXPECT_FALSE(made.store.cortex());
  const surface::DetailedCortex cortex{testing::octahedron(6), std::vector<float>(6, -1.5f)};
  saveBrainModel(made.store, brain, &cortex);
  const auto kept = made.store.cortex();
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->mesh.triangles.size(), 8u);
  EXPECT_EQ(kept->distance_mm, cortex.distance_mm);
  saveBrainModel(made.store, brain);
  EXPECT_FALSE(made.store.cortex());
}

TEST(EditedBrain, IsNotLostWhenTheCaseIsReplacedUnlessThatIsSaid) {
  const MadeCase made;
  const auto replace = [&](bool discard_edits) {
    return CaseStore::create(made.store.folder(), preparedCase(), {}, true, discard_edits);
  };
  saveBrainDraft(made.store, corrected(made.store, 50));
  EXPECT_THROW(replace(false), Error);
  removeBrainDraft(made.store);
  EXPECT_NO_THROW(replace(false));
  const auto mask = corrected(made.store, 100);
  saveEditedBrainMask(made.store, mask);
  try {
    replace(false);
    ADD_FAILURE() << "the corrected mask was dropped";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("corrected by hand"), std::string::npos);
  }
  EXPECT_EQ(made.store.brainMask()->voxels, mask.voxels);
  EXPECT_FALSE(hasEditedBrainMask(replace(true)));
  EXPECT_NE(made.store.brainMask()->voxels, mask.voxels);
}

}  // namespace
}  // namespace facenav::casefile
