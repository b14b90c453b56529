#include "facenav/dicom/patient.h"

#include <gmock/gmock.h>

#include "dicom_bytes.h"
#include "facenav/core/error.h"
#include "facenav/dicom/import_volume.h"
#include "patient_identity.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Throws;

std::vector<dicom::SeriesInfo> list(const fs::path& folder) {
  TaskMonitor monitor;
  return dicom::listSeries(folder, monitor);
}

/// A T1 of a whole head, fit to be recommended.
std::vector<Slice> headOf(const std::string& name, const std::string& id, const std::string& uid) {
  Slice s;
  s.rows = s.columns = 160;
  s.row_spacing = s.column_spacing = s.thickness = 1.2;
  s.patient_name = name;
  s.patient_id = id;
  s.series_uid = uid;
  return makeSlices(140, s);
}

TEST(Patient, OfTwoNoneIsRecommendedAndNoneTakenUnasked) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "a", headOf("Doe^Jane", "1", "1.1"));
  writeSlices(folder.path() / "b", headOf("Roe^Rose", "2", "1.2"));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(dicom::patientCount(series), 2);
  EXPECT_NE(series[0].patient, series[1].patient);
  for (const auto& info : series) EXPECT_TRUE(info.is_fit_for_navigation && !info.is_recommended);
  TaskMonitor monitor;
  EXPECT_THAT([&] { dicom::importVolume(folder.path(), std::nullopt, monitor); },
              Throws<Error>(::testing::Property(
                  &Error::what, HasSubstr("holds images of 2 patients; choose one with --series"))));
  EXPECT_EQ(dicom::importVolume(folder.path(), "1.2", monitor).series->series_uid, "1.2");
}

TEST(Patient, AnothersDamagedScanIsNotPassedOverInSilence) {
  const TemporaryFolder folder;
  auto damaged = headOf("Doe^Jane", "1", "1.1");
  damaged.erase(damaged.begin() + 70);
  writeSlices(folder.path() / "a", damaged);
  writeSlices(folder.path() / "b", headOf("Roe^Rose", "2", "1.2"));
  TaskMonitor monitor;
  EXPECT_THROW(dicom::importVolume(folder.path(), std::nullopt, monitor), Error);
}

TEST(Patient, ASharedSeriesUidIsSplitByPatient) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "a", headOf("Doe^Jane", "1", "1.1"));
  writeSlices(folder.path() / "b", headOf("Roe^Rose", "2", "1.1"));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 2u);
  for (const auto& info : series) EXPECT_TRUE(info.is_loadable && info.slices == 140) << info.problem;
  EXPECT_NE(series[0].id, series[1].id);
  EXPECT_NE(dicom::patientOf(series[0]).name, dicom::patientOf(series[1]).name);
}

TEST(Patient, ASingleSliceStandsForItsOwnPatientsSeries) {
  const TemporaryFolder folder;
  auto slices = headOf("Doe^Jane", "1", "1.1");
  for (Slice& s : headOf("Roe^Rose", "2", "1.1")) slices.push_back(s);
  writeSlices(folder.path(), slices);
  TaskMonitor monitor;
  const auto imported = dicom::importVolume(folder.path() / "f0", std::nullopt, monitor);
  EXPECT_EQ(dicom::patientOf(*imported.series).name, "Doe^Jane");
  EXPECT_EQ(imported.series->slices, 140);
}

TEST(Patient, OneWhoseNameIsWrittenInSeveralWaysIsOne) {
  EXPECT_TRUE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {"DOE^JANE^^", "1", "", "F"}));
  EXPECT_TRUE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {"Doe, Jane=", "1", "", ""}));
  EXPECT_FALSE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {"Doe^Jane", "2", "", ""}));
  EXPECT_FALSE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {"Doe^John", "1", "", ""}));
  EXPECT_FALSE(
      dicom::isSamePatient({"Doe^Jane", "1", "1970-01-31", ""}, {"Doe^Jane", "1", "1971-01-31", ""}));
  EXPECT_FALSE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {"", "", "", ""}));
}

TEST(Patient, InWords) {
  EXPECT_EQ(dicom::inWords({"Doe^Jane^Q^Dr", "4711", "1970-01-31", "F"}),
            "Doe, Jane Q Dr, born 1970-01-31, F, ID 4711");
  EXPECT_EQ(dicom::inWords({"Yamada^Tarou=\xE5\xB1\xB1\xE7\x94\xB0^\xE5\xA4\xAA\xE9\x83\x8E", "", "", ""}),
            "Yamada, Tarou");
  EXPECT_EQ(dicom::inWords({"", "4711", "", ""}), "4711");
  EXPECT_EQ(dicom::inWords({"^^^", "", "", ""}), "no patient named");
  EXPECT_EQ(dicom::nameInWords({"Doe^Jane", "4711", "", ""}), "Doe, Jane");
}

}  // namespace
}  // namespace facenav::testing
