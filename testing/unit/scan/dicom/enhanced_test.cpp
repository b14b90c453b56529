// Enhanced MR: many frames in one file, each with its place in functional groups (PS3.3 C.7.6.16).

#include "compare_volumes.h"
#include "enhanced_file.h"
#include "facenav/dicom/import_volume.h"

namespace facenav::testing {
namespace {

TEST(EnhancedMr, FramesArePlacedByTheirFunctionalGroups) {
  for (const Syntax& syntax : {explicitLittle(), implicitLittle(), explicitBig()}) {
    SCOPED_TRACE(syntax.uid);
    const TemporaryFolder folder;
    writeBytes(folder.path() / "in", enhancedFile({10, 1, syntax}));
    TaskMonitor monitor;
    const auto volume = dicom::importVolume(folder.path() / "in", std::nullopt, monitor).volume;
    ASSERT_EQ(volume.grid.size, (std::array<int, 3>{20, 24, 10}));
    // Row +y, column -z: normal -x, so index k runs from the frame of greatest x down. RAS of frame place 9.
    EXPECT_LT((volume.grid.toMri({2, 3, 0}).mm - Eigen::Vector3d(40 - 13.5, 80 - 2.2, 60 - 2.7)).norm(),
              1e-9);
    EXPECT_EQ(volume.at(2, 3, 0), float(2 * ((3 * 20 + 2 + 9000) % 4096) + 9));
  }
}

TEST(EnhancedMr, EchoesOfOneFileAreSplit) {
  const TemporaryFolder folder;
  writeBytes(folder.path() / "in", enhancedFile({10, 2, explicitLittle()}));
  TaskMonitor monitor;
  const auto series = dicom::listSeries(folder.path(), monitor);
  ASSERT_EQ(series.size(), 2u);
  for (const auto& info : series) {
    EXPECT_TRUE(info.is_loadable) << info.problem;
    EXPECT_EQ(info.slices, 10);
    const int echo = info.part == "echo 3.5 ms" ? 0 : 1;
    EXPECT_EQ(dicom::loadSeries(info, monitor).at(0, 0, 0), float(2 * ((9000 + 7 * echo) % 4096) + 9));
  }
}

Enhanced twelveFrames() {
  Enhanced spec;
  spec.frames = 12;
  return spec;
}

TEST(EnhancedMr, StacksThatTogetherAreOneEvenVolumeAreOne) {
  TaskMonitor monitor;
  const TemporaryFolder plain;
  writeBytes(plain.path() / "in", enhancedFile(twelveFrames()));
  const auto whole = dicom::importVolume(plain.path(), std::nullopt, monitor).volume;
  for (const bool has_slabs : {true, false}) {
    Enhanced spec = twelveFrames();
    spec.stacks = 3, spec.has_slabs = has_slabs;
    const TemporaryFolder folder;
    writeBytes(folder.path() / "in", enhancedFile(spec));
    const auto imported = dicom::importVolume(folder.path(), std::nullopt, monitor);
    EXPECT_EQ(imported.volume.voxels, whole.voxels) << has_slabs;
    EXPECT_TRUE(imported.volume.grid.matches(whole.grid));
    EXPECT_NE(imported.warnings.front().find("3 stacks"), std::string::npos) << imported.warnings.front();
  }
}

TEST(EnhancedMr, StacksApartStayApart) {
  Enhanced spec = twelveFrames();
  spec.stacks = 3, spec.has_slabs = true, spec.between_stacks_mm = 20;
  const TemporaryFolder folder;
  writeBytes(folder.path() / "in", enhancedFile(spec));
  TaskMonitor monitor;
  const auto series = dicom::listSeries(folder.path(), monitor);
  ASSERT_EQ(series.size(), 3u);
  for (const auto& info : series) EXPECT_EQ(info.slices, 4) << info.part;
}

}  // namespace
}  // namespace facenav::testing
