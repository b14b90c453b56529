#include <gmock/gmock.h>

#include <algorithm>

#include "dicom_bytes.h"
#include "facenav/core/error.h"
#include "facenav/dicom/import_volume.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

using ::testing::HasSubstr;

std::vector<dicom::SeriesInfo> listFolder(const std::filesystem::path& folder) {
  TaskMonitor monitor;
  return dicom::listSeries(folder, monitor);
}

/// Slice of a head-sized T1: 1.2 mm over more than 168 mm, since 128 x 128 voxels of 2 x 2 mm are refused.
Slice headSlice(const std::string& uid) {
  Slice s;
  s.rows = s.columns = 160;
  s.row_spacing = s.column_spacing = 1.2;
  s.thickness = 1.2;
  s.series_uid = uid;
  return s;
}

Slice small(const std::string& uid, const std::string& description) {
  Slice s;
  s.series_uid = uid;
  s.description = description;
  return s;
}

TEST(ListSeries, RecommendsTheThreeDimensionalT1) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "x/1", makeSlices(8, small("1.1", "t2_tse_tra")));
  writeSlices(folder.path() / "x/2", makeSlices(140, headSlice("1.2")));
  writeSlices(folder.path() / "y", makeSlices(8, small("1.3", "ep2d_diff")));
  const auto series = listFolder(folder.path());
  ASSERT_EQ(series.size(), 3u);
  EXPECT_EQ(series[0].series_uid, "1.2");
  EXPECT_TRUE(series[0].is_recommended && series[0].is_fit_for_navigation) << series[0].fitness;
  EXPECT_EQ(series[0].slices, 140);
  EXPECT_EQ(series[0].plane, "axial");
  EXPECT_EQ(series[0].contrast, "T1");
  EXPECT_EQ(series[0].date, "2020-01-02");
  EXPECT_FALSE(series[1].is_recommended || series[2].is_recommended);
  EXPECT_TRUE(series[1].is_loadable) << series[1].problem;
}

TEST(ListSeries, NothingOfThePatientIsRepeated) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(4));
  const auto info = listFolder(folder.path())[0];
  for (const std::string& text : {info.description, info.problem, info.fitness, info.part, info.date})
    EXPECT_THAT(text, Not(HasSubstr("Secret")));
}

TEST(ListSeries, EchoesAndPhaseUnderOneUidAreSplit) {
  const TemporaryFolder folder;
  auto slices = makeSlices(8);
  auto second = makeSlices(8);
  for (Slice& s : second) s.echo_ms = 8.1;
  auto phase = makeSlices(8);
  for (Slice& s : phase) s.image_type = "ORIGINAL\\PRIMARY\\P";
  writeSlices(folder.path() / "a", slices);
  writeSlices(folder.path() / "b", second);
  writeSlices(folder.path() / "c", phase);
  const auto series = listFolder(folder.path());
  ASSERT_EQ(series.size(), 3u);
  std::vector<std::string> ids;
  for (const auto& info : series) {
    EXPECT_TRUE(info.is_loadable) << info.problem;
    EXPECT_EQ(info.slices, 8);
    EXPECT_FALSE(info.part.empty());
    EXPECT_EQ(info.problem_kind, dicom::SeriesProblem::none);
    EXPECT_STREQ(dicom::idOf(info.problem_kind), "");
    EXPECT_EQ(info.is_magnitude_part, info.part.find("magnitude") != std::string::npos) << info.part;
    ids.push_back(info.id);
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
}

TEST(ListSeries, ManyVolumesOfOnePlaceAreFourD) {
  const TemporaryFolder folder;
  for (int t = 0; t < 3; ++t)
    writeSlices(folder.path() / std::to_string(t),
                makeSlices(6, {}, [t](Slice& s, int) { s.values[0] += t + 1; }));
  const auto series = listFolder(folder.path());
  ASSERT_EQ(series.size(), 1u);
  EXPECT_THAT(series[0].problem, HasSubstr("3 volumes of the same place (4-D)"));
  EXPECT_EQ(series[0].problem_kind, dicom::SeriesProblem::several_volumes);
  EXPECT_STREQ(dicom::idOf(series[0].problem_kind), "several_volumes");
}

TEST(ListSeries, ContrastAgentIsKnownWithoutReadingWords) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "plain", makeSlices(6, small("1.7", "t1")));
  writeSlices(folder.path() / "agent",
              makeSlices(6, small("1.8", "t1"), [](Slice& s, int) { s.contrast_agent = "GADOVIST"; }));
  for (const auto& info : listFolder(folder.path()))
    EXPECT_EQ(info.has_contrast_agent, info.series_uid == "1.8") << info.series_uid;
}

TEST(ListSeries, LocalizerInThreeDirectionsIsOneEntry) {
  const TemporaryFolder folder;
  auto slices = makeSlices(3, small("1.9", "localizer"));
  slices[1].row = {0, 1, 0}, slices[1].column = {0, 0, -1};
  slices[2].row = {1, 0, 0}, slices[2].column = {0, 0, -1};
  writeSlices(folder.path(), slices);
  const auto series = listFolder(folder.path());
  ASSERT_EQ(series.size(), 1u);
  EXPECT_THAT(series[0].problem, HasSubstr("localizer"));
}

TEST(ListSeries, SaysInWordsWhyNot) {
  const std::vector<std::pair<std::string, std::function<void(Slice&)>>> cases{
      {"modality OT", [](Slice& s) { s.sop_class = "1.2.840.10008.5.1.4.1.1.7", s.modality = "OT"; }},
      {"structured report", [](Slice& s) { s.sop_class = "1.2.840.10008.5.1.4.1.1.88.33"; }},
      {"PDF", [](Slice& s) { s.sop_class = "1.2.840.10008.5.1.4.1.1.104.1"; }},
      {"dose", [](Slice& s) { s.sop_class = "1.2.840.10008.5.1.4.1.1.481.2"; }},
      {"neither MR nor CT", [](Slice& s) { s.modality = "PT"; }},
      {"mosaic", [](Slice& s) { s.image_type = "ORIGINAL\\PRIMARY\\M\\MOSAIC"; }},
      {"localizer", [](Slice& s) { s.image_type = "ORIGINAL\\PRIMARY\\LOCALIZER"; }},
      {"colour", [](Slice& s) { s.photometric = "PALETTE COLOR"; }},
      {"impossible size", [](Slice& s) { s.rows = 60000; }},
      {"not read", [](Slice& s) { s.syntax.uid = "1.2.840.10008.1.2.4.100"; }},
  };
  for (const auto& [words, change] : cases) {
    SCOPED_TRACE(words);
    const TemporaryFolder folder;
    writeSlices(folder.path(), makeSlices(4, {}, [&change = change](Slice& s, int) { change(s); }));
    const auto series = listFolder(folder.path());
    ASSERT_EQ(series.size(), 1u);
    EXPECT_FALSE(series[0].is_loadable);
    EXPECT_THAT(series[0].problem, HasSubstr(words));
  }
}

/// A path may contain the patient's name, so the listed problem is the fault alone. A blank in place of the
/// path's tab once prevented its removal.
TEST(ListSeries, TheFaultOfADamagedFileIsNamedWithoutItsPath) {
  for (const char* name : {"export", "Doe\tJane; export"}) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    const auto where = folder.path() / name;
    writeSlices(where, makeSlices(4));
    const auto damaged = std::filesystem::directory_iterator(where)->path();
    std::filesystem::resize_file(damaged, 200);
    for (const auto& info : listFolder(where)) {
      EXPECT_EQ(info.problem_kind, dicom::SeriesProblem::damaged);
      EXPECT_EQ(info.problem_file, damaged);
      EXPECT_THAT(info.problem, HasSubstr("DICOM header is cut off or damaged"));
      EXPECT_EQ(info.problem.find("Jane"), std::string::npos) << info.problem;
      EXPECT_EQ(info.problem.find("again"), std::string::npos) << info.problem;
    }
  }
}

TEST(ListSeries, CtGivesTheScalpOnly) {
  const TemporaryFolder folder;
  auto first = headSlice("1.5");
  first.modality = "CT";
  first.sop_class = "1.2.840.10008.5.1.4.1.1.2";
  writeSlices(folder.path(), makeSlices(20, first));
  const auto series = listFolder(folder.path());
  EXPECT_TRUE(series[0].is_loadable);
  EXPECT_FALSE(series[0].is_recommended);
  EXPECT_THAT(series[0].fitness, HasSubstr("scalp only"));
}

TEST(ListSeries, OtherFilesArePassedOver) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(4));
  writeBytes(folder.path() / "notes.txt",
             "nothing to see here, and quite long enough to be looked into by a reader\n");
  writeBytes(folder.path() / "empty", "");
  EXPECT_EQ(listFolder(folder.path()).size(), 1u);
}

/// A table of contents (PS3.10 8), identified only by the SOP class in its meta header.
std::string dicomDir() {
  DataSetBytes meta(explicitLittle());
  meta.raw(0x00020002, "UI", "1.2.840.10008.1.3.10").raw(0x00020010, "UI", "1.2.840.10008.1.2.1");
  DataSetBytes length(explicitLittle());
  length.raw(0x00020000, "UL", length.encoded(std::uint32_t(meta.bytes().size()), 4));
  DataSetBytes content(explicitLittle());
  content.raw(0x00041130, "CS", "EXPORT").sequence(0x00041220, {});
  return std::string(128, '\0') + "DICM" + length.bytes() + meta.bytes() + content.bytes();
}

TEST(ListSeries, DicomDirStandsForItsFolder) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "IMAGES/A", makeSlices(4));
  writeBytes(folder.path() / "DICOMDIR", dicomDir());
  for (const auto& input : {folder.path(), folder.path() / "DICOMDIR"}) {
    const auto series = listFolder(input);
    ASSERT_EQ(series.size(), 1u) << input;
    EXPECT_TRUE(series[0].is_loadable) << series[0].problem;
  }
  TaskMonitor monitor;
  EXPECT_EQ(dicom::importVolume(folder.path() / "DICOMDIR", std::nullopt, monitor).volume.grid.size[2], 4);
}

TEST(ListSeries, DamagedDicomDirLeavesTheSeriesBesideItAlone) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(4));
  const std::string whole = dicomDir();
  writeBytes(folder.path() / "DICOMDIR", whole.substr(0, whole.size() - 5));
  const auto series = listFolder(folder.path());
  ASSERT_EQ(series.size(), 1u);
  EXPECT_TRUE(series[0].is_loadable) << series[0].problem;
}

TEST(ListSeries, RefusesWhatHoldsNoDicom) {
  const TemporaryFolder folder;
  EXPECT_THROW(listFolder(folder.path()), Error);
  EXPECT_THROW(listFolder(folder.path() / "absent"), Error);
  writeBytes(folder.path() / "a.txt", "hello");
  EXPECT_THROW(listFolder(folder.path()), Error);
}

TEST(ImportVolume, SeriesIsChosenByItsId) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "1", makeSlices(8, small("1.1", "t2_tse_tra")));
  writeSlices(folder.path() / "2", makeSlices(9, small("1.2", "t2_tse_cor")));
  TaskMonitor monitor;
  EXPECT_EQ(dicom::importVolume(folder.path(), "1.2", monitor).volume.grid.size[2], 9);
  EXPECT_THROW(dicom::importVolume(folder.path(), std::nullopt, monitor),
               Error);  // two series, none of them a T1
  EXPECT_THROW(dicom::importVolume(folder.path(), "1.7", monitor), Error);
}

TEST(ImportVolume, SmallSeriesDoesNotStandInForADamagedLargeOne) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "1", makeSlices(4, small("1.1", "t2_tse_tra")));
  auto damaged = makeSlices(30, small("1.2", "t1"));
  damaged.erase(damaged.begin() + 9);
  writeSlices(folder.path() / "2", damaged);
  TaskMonitor monitor;
  EXPECT_THROW(dicom::importVolume(folder.path(), std::nullopt, monitor), Error);
}

TEST(ImportVolume, CancelStopsTheScan) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(4));
  TaskMonitor monitor;
  monitor.cancel();
  EXPECT_THROW(dicom::importVolume(folder.path(), std::nullopt, monitor), Cancelled);
}

}  // namespace
}  // namespace facenav::testing
