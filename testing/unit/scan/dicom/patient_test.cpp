#include "facenav/dicom/patient.h"

#include <gmock/gmock.h>

#include "dicom_bytes.h"
#include "facenav/core/error.h"
#include "facenav/dicom/import_volume.h"
#include "header/patient_identity.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Throws;

std::vector<dicom::SeriesInfo> listPatient(const fs::path& folder) {
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
  const auto series = listPatient(folder.path());
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
  const auto series = listPatient(folder.path());
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
  EXPECT_TRUE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {" doe, jane", "1", "", ""}));
  EXPECT_FALSE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {"Doe^Jane", "2", "", ""}));
  EXPECT_FALSE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {"Doe^John", "1", "", ""}));
  EXPECT_FALSE(
      dicom::isSamePatient({"Doe^Jane", "1", "1970-01-31", ""}, {"Doe^Jane", "1", "1971-01-31", ""}));
  EXPECT_FALSE(dicom::isSamePatient({"Doe^Jane", "1", "", ""}, {"", "", "", ""}));
}

TEST(Patient, InWords) {
  EXPECT_EQ(dicom::inWords({"Doe^Jane^Q^Dr", "4711", "1970-01-31", "F"}),
            "Doe, Jane Q Dr, born 1970-01-31, F, ID 4711");
  EXPECT_EQ(dicom::inWords({"", "4711", "", ""}), "4711");
  EXPECT_EQ(dicom::inWords({"^^^", "", "", ""}), "no patient named");
  EXPECT_EQ(dicom::nameInWords({"Doe^Jane", "4711", "", ""}), "Doe, Jane");
}

std::string nameRead(const std::string& raw, const std::string& character_set) {
  const TemporaryFolder folder;
  Slice s;
  s.patient_name = raw;
  s.character_set = character_set;
  writeSlices(folder.path(), makeSlices(4, s));
  return dicom::patientOf(listPatient(folder.path())[0]).name;
}

/// Uses names of PS3.5 annexes H to K, and of Latin, Cyrillic and Greek sets.
TEST(Patient, NamesAreReadInTheFilesOwnCharacterSet) {
  EXPECT_EQ(nameRead("Buc^J\xE9r\xF4me", "ISO_IR 100"), "Buc^J\u00e9r\u00f4me");
  EXPECT_EQ(nameRead("Dvo\xF8\xE1k^Jan", "ISO_IR 101"), "Dvo\u0159\u00e1k^Jan");
  EXPECT_EQ(nameRead("\xBB\xEE\xDA^\xD1", "ISO_IR 144"), "\u041b\u044e\u043a^\u0431");
  EXPECT_EQ(nameRead("\xC4\xE9\xEF\xED", "ISO 2022 IR 126"), "\u0394\u03b9\u03bf\u03bd");
  EXPECT_EQ(nameRead("J\xC3\xA9r\xC3\xB4me", "ISO_IR 192"), "J\u00e9r\u00f4me");
  EXPECT_EQ(nameRead("J\xC3\xA9r\xC3\xB4me", "ISO_IR 100"), "J\u00e9r\u00f4me") << "mislabelled";
  EXPECT_EQ(nameRead("Yamada^Tarou=\x1B$B;3ED\x1B(B^\x1B$BB@O:\x1B(B=\x1B$B$d$^$@\x1B(B^\x1B$B$?$m$&\x1B(B",
                     "\\ISO 2022 IR 87"),
            "Yamada^Tarou");
  EXPECT_EQ(nameRead("=\x1B$B;3ED\x1B(B^\x1B$BB@O:\x1B(B", "\\ISO 2022 IR 87"), "\u5c71\u7530^\u592a\u90ce");
  EXPECT_EQ(nameRead("\xD4\xCF\xC0\xDE^\xC0\xDB\xB3=\x1B$B;3ED\x1B(J", "ISO 2022 IR 13\\ISO 2022 IR 87"),
            "\uff94\uff8f\uff80\uff9e^\uff80\uff9b\uff73");
  EXPECT_EQ(nameRead("=\x1B$)C\xFB\xF3^\x1B$)C\xD1\xCE\xD4\xD7", "\\ISO 2022 IR 149"), "\u6d2a^\u5409\u6d1e");
  EXPECT_EQ(nameRead("Wang^XiaoDong=\xCD\xF5^\xD0\xA1\xB6\xAB", "GB18030"), "Wang^XiaoDong");
  EXPECT_EQ(nameRead("=\xCD\xF5^\xD0\xA1\xB6\xAB", "GB18030"), "\u738b^\u5c0f\u4e1c");
  EXPECT_EQ(nameRead("J\xE9r\xF4me", "nonsense"), "J\u00e9r\u00f4me") << "taken for Latin-1";
  EXPECT_EQ(nameRead("J\x1B\xE9r", "\\ISO 2022 IR 87"), "J \u00e9r") << "not what it says";
}

}  // namespace
}  // namespace facenav::testing
