#include "facenav/dicom/joined_slices.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>

#include "apart_slices.h"
#include "facenav/core/error.h"
#include "facenav/dicom/patient.h"
#include "series/single_slices.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using dicom::SeriesProblem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Property;
using ::testing::Throws;

TEST(JoinedSlices, GiveTheVolumeOfTheProperExport) {
  const auto slices = makeSlices(40, oblique());
  const TemporaryFolder folder;
  writeSlices(folder.path(), apart(slices));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 1u);
  ASSERT_TRUE(series[0].is_loadable && series[0].joined) << series[0].problem;
  EXPECT_EQ(series[0].slices, 40);
  EXPECT_EQ(series[0].joined->series_uids, 40);
  EXPECT_EQ(series[0].joined->study_uids, 40);
  EXPECT_EQ(series[0].joined->frame_of_reference_uids, 40);
  EXPECT_EQ(series[0].joined->readings, 1);
  EXPECT_EQ(dicom::findingId(*series[0].joined), "slices_joined");
  expectSameVolume(load(series[0]), properVolume(slices));
}

TEST(JoinedSlices, AreNamedByTheFirstUidWhateverTheFilesAreCalled) {
  auto slices = apart(makeSlices(12, oblique()));
  std::mt19937 random(3);
  for (int round = 0; round < 3; ++round) {
    const TemporaryFolder folder;
    std::shuffle(slices.begin(), slices.end(), random);
    writeSlices(folder.path(), slices);
    const auto info = list(folder.path()).at(0);
    EXPECT_EQ(info.id, "2.25.77.2.1");
    EXPECT_EQ(info.study_uid, "2.25.77.1.1");
    EXPECT_EQ(info.joined->frame_of_reference_uid, "2.25.77.3.1");
  }
}

TEST(JoinedSlices, ProperSeriesStayAsTheyAre) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(12, oblique()));
  EXPECT_FALSE(list(folder.path()).at(0).joined);
}

/// Ten series of three slices, alike in everything but their UIDs and positions, stay ten.
TEST(JoinedSlices, TrueSeriesOfSeveralSlicesAreNeverMerged) {
  auto slices = makeSlices(30, oblique());
  for (std::size_t k = 0; k < slices.size(); ++k) slices[k].series_uid = "1.5." + std::to_string(k / 3);
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  EXPECT_EQ(list(folder.path()).size(), 10u);
}

TEST(JoinedSlices, AFewSingleSlicesStayAlone) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), apart(makeSlices(int(dicom::kFewestJoined) - 1, oblique())));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), dicom::kFewestJoined - 1);
  EXPECT_EQ(series[0].problem_kind, SeriesProblem::single_slice);
}

TEST(JoinedSlices, AreSaidInAFindingThatNamesNoPatient) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), apart(makeSlices(12, oblique())));
  const auto imported = import(folder.path());
  ASSERT_FALSE(imported.warnings.empty());
  EXPECT_EQ(imported.warnings[0],
            "slices with 12 different series UIDs were joined: geometry, timing, patient, series number, "
            "series time and description agree. No UID says that they share a frame of reference: look for "
            "steps between slices");
  EXPECT_THAT(imported.warnings[0], Not(HasSubstr("Secret")));
}

TEST(JoinedSlices, InWordsSayWhatAgreesAndWhatIsNotGiven) {
  using dicom::SliceTrait;
  dicom::JoinedSlices joined;
  joined.series_uids = 9, joined.frame_of_reference_uids = 1, joined.readings = 2;
  joined.unstated = {SliceTrait::patient, SliceTrait::series_number, SliceTrait::series_time};
  EXPECT_EQ(
      dicom::inWords(joined),
      "slices with 9 different series UIDs were joined: geometry and timing agree, no patient, series "
      "number or series time is given; one of 2 ways to read them: choose the right one. They share one "
      "frame-of-reference UID");
  joined.agreeing = {SliceTrait::description};
  joined.unstated.clear();
  EXPECT_THAT(dicom::inWords(joined), HasSubstr("joined: geometry, timing and description agree; one of 2"));
}

TEST(JoinedSlices, AnonymisersLeaveLess) {
  const auto slices = makeSlices(24, oblique());
  const volume::Volume truth = properVolume(slices);
  const std::vector<std::pair<std::string, std::function<void(Slice&, int)>>> cases{
      {"no series number", [](Slice& s, int) { s.series_number.clear(); }},
      {"no series time", [](Slice& s, int) { s.series_time.clear(); }},
      {"a time of its own each", [](Slice& s, int k) { s.series_time = std::to_string(101500 + k); }},
      {"one SOP instance UID", [](Slice& s, int) { s.sop_uid = "1.1"; }},
      {"nobody named", [](Slice& s, int) { s.patient_name.clear(), s.patient_id.clear(); }},
      {"frame of reference kept", [](Slice& s, int) { s.frame_uid = "1.9"; }},
      {"study kept", [](Slice& s, int) { s.study_uid = "1.8"; }},
      {"nothing but geometry",
       [](Slice& s, int) {
         for (auto* text : {&s.series_number, &s.series_time, &s.description, &s.patient_name, &s.patient_id})
           text->clear();
       }},
  };
  for (const auto& [words, change] : cases) {
    SCOPED_TRACE(words);
    auto less = apart(slices);
    for (std::size_t k = 0; k < less.size(); ++k) change(less[k], int(k));
    const TemporaryFolder folder;
    writeSlices(folder.path(), less);
    const auto series = list(folder.path());
    ASSERT_EQ(series.size(), 1u);
    ASSERT_TRUE(series[0].is_loadable) << series[0].problem;
    EXPECT_EQ(series[0].joined->readings, 1);
    expectSameVolume(load(series[0]), truth);
  }
}

TEST(JoinedSlices, WithoutInstanceNumbersLieWhereTheProperOnesDo) {
  auto slices = makeSlices(24, oblique());
  for (Slice& s : slices) s.instance = 1;
  const TemporaryFolder folder;
  writeSlices(folder.path(), apart(slices));
  expectSameVolume(load(list(folder.path()).at(0)), properVolume(slices));
}

TEST(JoinedSlices, AMissingSliceIsNoticed) {
  auto slices = apart(makeSlices(24, oblique()));
  slices.erase(slices.begin() + 11);
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 1u);
  EXPECT_EQ(series[0].problem_kind, SeriesProblem::damaged);
  EXPECT_THAT(series[0].problem, HasSubstr("1 slice is missing"));
}

TEST(JoinedSlices, ADamagedFileTakesThemWithIt) {
  const auto slices = apart(makeSlices(24, oblique()));
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  const std::string last = sliceFile(slices.back());
  for (const auto& file : fs::directory_iterator(folder.path()))
    if (fs::file_size(file) == last.size()) {
      writeBytes(file.path(), last.substr(0, 300));
      break;
    }
  for (const auto& info : list(folder.path())) EXPECT_FALSE(info.is_loadable);
}

TEST(JoinedSlices, TwoScansAndALocalizerStayThree) {
  Slice first = oblique(), second = oblique(), scout = oblique();
  second.series_number = "7", second.series_time = "103000";
  scout.series_number = "1", scout.description = "localizer", scout.rows = 32, scout.thickness = 8;
  const auto a = makeSlices(30, first), b = makeSlices(30, second);
  const TemporaryFolder folder;
  writeSlices(folder.path() / "x", apart(a, "2.25.5"));
  writeSlices(folder.path() / "y", apart(b, "2.25.6"));
  writeSlices(folder.path() / "z", makeSlices(5, scout));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 3u);
  for (const auto& info : series) {
    EXPECT_EQ(info.joined.has_value(), info.series_number != 1);
    EXPECT_TRUE(!info.joined || (info.slices == 30 && info.joined->readings == 1)) << info.part;
  }
  expectSameVolume(load(series[0].series_number == 3 ? series[0] : series[1]), properVolume(a));
}

TEST(JoinedSlices, PatientsAreNeverMerged) {
  Slice other = oblique();
  other.patient_name = "Roe^Rose", other.patient_id = "2";
  auto slices = apart(makeSlices(24, oblique()));
  const auto theirs = apart(makeSlices(24, other));  // even under the same UIDs
  for (std::size_t k = 0; k < slices.size(); k += 2) slices[k] = theirs[k];
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 2u);
  for (const auto& info : series) EXPECT_EQ(info.slices, 12);
  EXPECT_NE(dicom::patientOf(series[0]).name, dicom::patientOf(series[1]).name);
  EXPECT_THAT([&] { import(folder.path()); },
              Throws<Error>(Property(&Error::what, HasSubstr("holds images of 2 patients"))));
}

TEST(JoinedSlices, NobodyNamedOfAnotherAgeIsAnother) {
  auto slices = apart(makeSlices(24, oblique()));
  const TemporaryFolder folder;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    slices[k].patient_name.clear(), slices[k].patient_id.clear();
    DataSetBytes d = headerOf(slices[k]);
    d.raw(0x00101010, "AS", k < 12 ? "042Y" : "017Y");
    writeBytes(folder.path() / std::to_string(k), fileOf(d.raw(0x7FE00010, "OW", pixelBytes(slices[k]))));
  }
  EXPECT_EQ(list(folder.path()).size(), 2u);
}

TEST(JoinedSlices, CopiesAreDropped) {
  const auto slices = makeSlices(16, oblique());
  const TemporaryFolder folder;
  writeSlices(folder.path() / "x", apart(slices));
  writeSlices(folder.path() / "y", apart(slices));            // the same files again
  writeSlices(folder.path() / "z", apart(slices, "2.25.8"));  // anonymised a second time
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 1u);
  ASSERT_TRUE(series[0].is_loadable) << series[0].problem;
  expectSameVolume(load(series[0]), properVolume(slices));
}

TEST(JoinedSlices, OneOfThemStandsForAll) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), apart(makeSlices(16, oblique())));
  EXPECT_EQ(import(folder.path() / "f0").volume.grid.size[2], 16);
}

TEST(JoinedSlices, AFileReplacedSinceTheListIsRefused) {
  Slice other = oblique();
  other.description = "t2_tse";
  const TemporaryFolder folder;
  writeSlices(folder.path(), apart(makeSlices(16, oblique())));
  const auto info = list(folder.path()).at(0);
  writeBytes(info.files[5], sliceFile(makeSlices(1, other)[0]));
  EXPECT_THROW(load(info), Error);
}

/// The real T1's 384 slices with the last digits of their three UIDs replaced by the slice's number.
TEST(JoinedSlices, RealT1WithUidsOfItsOwnInEverySliceIsTheSameVolume) {
  FACENAV_NEEDS(t1Dicom());
  const TemporaryFolder folder;
  int slice = 0;
  for (const auto& entry : fs::directory_iterator(t1Dicom())) {
    std::ifstream file(entry.path(), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.size() < 132 || bytes.compare(128, 4, "DICM") != 0) continue;
    char digits[16];
    std::snprintf(digits, sizeof digits, "%04d", ++slice);
    for (const char* end : {"112155415165916", "111326823367652", "724161920598374"})  // study, series, frame
      for (std::size_t at = bytes.find(end); at != std::string::npos; at = bytes.find(end, at + 1))
        bytes.replace(at + std::strlen(end) - 4, 4, digits);
    writeBytes(folder.path() / entry.path().filename(), bytes);
  }
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 1u);
  ASSERT_TRUE(series[0].joined && series[0].is_recommended) << series[0].problem;
  EXPECT_EQ(series[0].joined->series_uids, 384);
  EXPECT_EQ(series[0].joined->frame_of_reference_uids, 384);
  expectSameVolume(load(series[0]), load(list(t1Dicom()).at(0)));
}

}  // namespace
}  // namespace facenav::testing
