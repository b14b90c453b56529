#include "facenav/casefile/exporter.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "made_case.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

CaseStore madeExportStore(const fs::path& folder) {
  return CaseStore::create(folder / "case", testing::preparedCase(), {}, false);
}

TEST(Exporter, WritesScalpBrainAndCortexForTheUserAlone) {
  const facenav::testing::TemporaryFolder folder;
  const auto out = folder.path() / "for_printing";
  TaskMonitor monitor;
  const auto written =
      makeMeshExporter(surface::MeshFormat::stl)->write(madeExportStore(folder.path()), out, false, monitor);
  EXPECT_THAT(written, ElementsAre(out / "scalp.stl", out / "brain.stl", out / "cortex.stl"));
  for (const auto& path : written) {
    EXPECT_GT(fs::file_size(path), 84u) << "more than STL's header";
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  }
}

TEST(Exporter, OverwritesNothingUnasked) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeExportStore(folder.path());
  TaskMonitor monitor;
  const auto exporter = makeNiftiExporter();
  EXPECT_EQ(exporter->write(store, folder.path() / "out", false, monitor).size(), 3u);
  EXPECT_THROW(exporter->write(store, folder.path() / "out", false, monitor), Error);
  EXPECT_EQ(exporter->write(store, folder.path() / "out", true, monitor).size(), 3u);
}

TEST(Exporter, ACaseWithoutABrainGivesItsScalpOnly) {
  const facenav::testing::TemporaryFolder folder;
  auto prepared = testing::preparedCase();
  prepared.brain.reset();
  prepared.brain_mask.reset();
  const auto store = CaseStore::create(folder.path() / "case", prepared, {}, false);
  TaskMonitor monitor;
  EXPECT_THAT(makeMeshExporter(surface::MeshFormat::ply)->write(store, folder.path() / "out", false, monitor),
              ElementsAre(folder.path() / "out/scalp.ply"));
}

TEST(Exporter, AFileInThePlaceOfTheFolderIsRefused) {
  const facenav::testing::TemporaryFolder folder;
  writeWholeFile(folder.path() / "out", "not a folder");
  TaskMonitor monitor;
  EXPECT_THROW(
      makeNiftiExporter()->write(madeExportStore(folder.path()), folder.path() / "out", false, monitor),
      Error);
}

}  // namespace
}  // namespace facenav::casefile
