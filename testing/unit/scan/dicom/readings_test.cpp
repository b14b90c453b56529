// Slices with UIDs of their own that can be read in more than one way.

#include <gmock/gmock.h>

#include <algorithm>

#include "apart_slices.h"
#include "facenav/core/error.h"

namespace facenav::testing {
namespace {

using dicom::SeriesProblem;
using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::Throws;

TEST(Readings, TwoRepetitionsAreAskedAbout) {
  const auto first = makeSlices(20, oblique());
  auto second = again(first);
  for (Slice& s : second) s.instance += 20;
  auto one = apart(first, "2.25.5"), two = apart(second, "2.25.6");
  for (Slice& s : one) s.acquisition = 1;
  for (Slice& s : two) s.acquisition = 2;
  const TemporaryFolder folder;
  writeSlices(folder.path(), both(one, two));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 3u);  // the readings by acquisition number and by instance order give the same two
  EXPECT_EQ(dicom::readingCount(series), 2);
  std::vector<std::string> ids;
  for (const auto& info : series) {
    EXPECT_FALSE(info.is_recommended);
    EXPECT_EQ(info.joined->readings, 2);
    EXPECT_EQ(dicom::findingId(*info.joined), "slices_joined_in_several_ways");
    EXPECT_EQ(info.is_loadable, info.part != "all slices") << info.part;
    EXPECT_EQ(info.problem_kind == SeriesProblem::several_volumes, info.part == "all slices");
    ids.push_back(info.id);
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
  EXPECT_THAT(
      [&] { import(folder.path()); },
      Throws<Error>(Property(
          &Error::what, HasSubstr("can be read in 2 ways (acquisition number 1; acquisition number 2)"))));
  for (const auto& info : series)
    if (info.part == "acquisition number 2")
      expectSameVolume(import(folder.path(), info.id).volume, properVolume(second));
}

TEST(Readings, EchoesArePartsAsInAProperExport) {
  auto first = makeSlices(20, oblique()), second = again(first);
  for (Slice& s : second) s.echo_ms = 8.1;
  const TemporaryFolder folder;
  writeSlices(folder.path(), both(apart(first, "2.25.5"), apart(second, "2.25.6")));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(dicom::readingCount(series), 0);
  for (const auto& info : series)
    expectSameVolume(load(info), properVolume(info.part == "echo 8.1 ms" ? second : first));
}

TEST(Readings, InterleavedRepetitionsAreToldApartByInstanceOrder) {
  auto first = makeSlices(20, oblique()), second = again(first);
  for (std::size_t k = 0; k < first.size(); ++k)
    first[k].instance = int(2 * k + 1), second[k].instance = int(2 * k + 2);
  const TemporaryFolder folder;
  writeSlices(folder.path(), both(apart(first, "2.25.5"), apart(second, "2.25.6")));
  const auto series = list(folder.path());
  EXPECT_EQ(dicom::readingCount(series), 2);
  for (const auto& info : series)
    if (info.part == "instance order 1 of 2") expectSameVolume(load(info), properVolume(first));
}

TEST(Readings, RepetitionsThatNothingTellsApartAreRefused) {
  const auto first = makeSlices(20, oblique());
  const TemporaryFolder folder;
  writeSlices(folder.path(), both(apart(first, "2.25.5"), apart(again(first), "2.25.6")));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 1u);
  EXPECT_EQ(series[0].problem_kind, SeriesProblem::several_volumes);
}

/// Slices of 3 mm every 1.5 mm, numbered 1 to 12 twice: one overlapping stack, or two scans half a slice
/// apart.
TEST(Readings, DenserThanStatedWithRepeatedNumbersIsAskedAbout) {
  auto slices = makeSlices(24, oblique());
  for (std::size_t k = 0; k < slices.size(); ++k)
    slices[k].instance = int(k / 2 + 1), slices[k].thickness = 3;
  const TemporaryFolder folder, stated;
  writeSlices(folder.path(), apart(slices));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 3u);
  EXPECT_EQ(dicom::readingCount(series), 3);
  for (const auto& info : series) EXPECT_EQ(info.slices, info.part == "all slices" ? 24 : 12);
  EXPECT_THROW(import(folder.path()), Error);
  for (Slice& s : slices) s.gap = 1.5;  // the files declare one stack
  writeSlices(stated.path(), apart(slices));
  EXPECT_EQ(list(stated.path()).size(), 1u);
}

TEST(Readings, TwoScansOfOtherGapsAreAskedAbout) {
  Slice other = oblique();
  const Eigen::Vector3d normal = other.row.cross(other.column);
  auto first = makeSlices(20, oblique());
  auto second = makeSlices(10, other, [&](Slice& s, int k) { s.position += normal * (0.35 + 1.1 * k); });
  for (Slice& s : first) s.acquisition = 1;
  for (Slice& s : second) s.acquisition = 2;
  const TemporaryFolder folder;
  writeSlices(folder.path(), both(apart(first, "2.25.5"), apart(second, "2.25.6")));
  const auto series = list(folder.path());
  EXPECT_EQ(dicom::readingCount(series), 2);
  EXPECT_THROW(import(folder.path()), Error);
  for (const auto& info : series)
    if (info.part == "acquisition number 1") expectSameVolume(load(info), properVolume(first));
}

}  // namespace
}  // namespace facenav::testing
