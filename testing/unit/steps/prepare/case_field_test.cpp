// The electric field's model kept with a case.

#include "facenav/prepare/case_field.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/nifti.h"
#include "support/ball_with_cortex.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using facenav::testing::ballWithCortex;
using facenav::testing::refusalOf;
using facenav::testing::TemporaryFolder;

TEST(CaseField, IsKeptUntilTheBrainChanges) {
  const TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", ballWithCortex(), {}, false);
  EXPECT_FALSE(keptField(store));
  TaskMonitor monitor;
  const efield::CortexField built = buildField(store, monitor);
  EXPECT_EQ(std::size_t(built.points_mm.cols()), fieldVertices(store.cortex()->mesh).size());
  EXPECT_LT(std::filesystem::file_size(fieldFile(store)), 60e6);
  const auto kept = keptField(store);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->points_mm, built.points_mm);

  // The field in a ball has no part towards the middle.
  const efield::CoilDipoles coil{Eigen::Vector3d(0, 0, -8), Eigen::Vector3d(0, 0, 0.03), 0, "one dipole"};
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  pose(1, 1) = pose(2, 2) = -1;
  pose(2, 3) = 90;
  const auto field = fieldAt(*kept, coil, RigidTransform<Mri, frames::Coil>::fromMatrix(pose));
  const auto radial =
      (field.array() * kept->points_mm.array()).colwise().sum() / kept->points_mm.colwise().norm().array();
  EXPECT_LT(radial.abs().maxCoeff(), 0.06 * field.colwise().norm().maxCoeff());

  volume::Mask changed = *store.brainMask();
  changed.voxels[changed.grid.index(25, 25, 25)] = 0;
  volume::writeMask(changed, store.folder() / "brain_mask.nii.gz");
  EXPECT_FALSE(keptField(store)) << "another brain mask";
}

// 600 + 3 x 162 equations.
const FieldMesh kCoarse{2, 600};

TEST(CaseField, TheModelWithTheFluidIsKeptBesideTheOneWithout) {
  const TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", ballWithCortex(), {}, false);
  TaskMonitor monitor;
  const auto three = buildField(store, monitor, FieldTier::three_shells, kCoarse);
  EXPECT_FALSE(hasField(store, FieldTier::four_shells));
  const auto four = buildField(store, monitor, FieldTier::four_shells, kCoarse);
  EXPECT_NE(fieldFile(store, FieldTier::four_shells), fieldFile(store));
  EXPECT_LT(std::filesystem::file_size(fieldFile(store, FieldTier::four_shells)), 60e6);
  const auto kept = keptField(store, FieldTier::four_shells);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->points_mm, four.points_mm);
  EXPECT_EQ(keptField(store)->points_mm, three.points_mm);

  volume::Mask changed = *store.brainMask();
  changed.voxels[changed.grid.index(25, 25, 25)] = 0;
  volume::writeMask(changed, store.folder() / "brain_mask.nii.gz");
  EXPECT_FALSE(hasField(store, FieldTier::four_shells)) << "another brain mask";
  EXPECT_FALSE(keptField(store, FieldTier::four_shells));
}

TEST(CaseField, ACancelledModelLeavesNothing) {
  const TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", ballWithCortex(), {}, false);
  const auto count = [&] {
    return std::distance(std::filesystem::directory_iterator(store.folder()),
                         std::filesystem::directory_iterator());
  };
  const auto before = count();
  // Cancelled at each of its stages.
  for (const std::string stage : {"surfaces", "equations", "solving", "modes"}) {
    TaskMonitor* cancelled = nullptr;
    TaskMonitor monitor([&](const std::string& step, double) {
      if (step == "electric field: " + stage) cancelled->cancel();
    });
    cancelled = &monitor;
    EXPECT_THROW(buildField(store, monitor, FieldTier::four_shells, kCoarse), Cancelled) << stage;
    EXPECT_EQ(count(), before) << stage;
  }
}

TEST(CaseField, ADamagedFileIsSaid) {
  const TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", ballWithCortex(), {}, false);
  writeWholeFile(fieldFile(store), "nothing of a field");
  EXPECT_NE(refusalOf([&] { keptField(store); }).find("damaged"), std::string::npos);
}

TEST(CaseField, ACaseWithoutABrainIsRefused) {
  const TemporaryFolder folder;
  const auto store =
      casefile::CaseStore::create(folder.path() / "case", facenav::testing::ballCase(), {}, false);
  TaskMonitor monitor;
  EXPECT_NE(refusalOf([&] { buildField(store, monitor); }).find("no brain"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(fieldFile(store)));
}

}  // namespace
}  // namespace facenav::steps
