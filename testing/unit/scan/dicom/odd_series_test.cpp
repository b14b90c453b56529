// Series as hospitals hand them over: files lost on the way, kinds mixed, bright and dark exchanged,
// identities scattered, archives instead of files. What is lost or odd is named.

#include <gmock/gmock.h>

#include <functional>

#include "apart_slices.h"
#include "dicom_bytes.h"
#include "facenav/core/error.h"
#include "facenav/dicom/character_set.h"
#include "facenav/dicom/import_volume.h"
#include "facenav/dicom/patient.h"
#include "facenav/volume/voxel_size.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

/// Writes slices under names in their order: s01.dcm, ..
void writeInOrder(const std::filesystem::path& folder, const std::vector<Slice>& slices) {
  for (std::size_t k = 0; k < slices.size(); ++k)
    writeBytes(folder / ("s" + std::to_string(101 + k) + ".dcm"), sliceFile(slices[k]));
}

std::string faultOf(const std::filesystem::path& input) {
  try {
    import(input);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(LostFiles, EmptyOnesAreCountedInOneNote) {
  const TemporaryFolder folder;
  writeInOrder(folder.path(), makeSlices(12));
  for (const char* name : {"s113.dcm", "s114.dcm", "lock", ".nomedia"}) writeBytes(folder.path() / name, "");
  const auto imported = import(folder.path());
  EXPECT_EQ(imported.volume.grid.size[2], 12);
  EXPECT_THAT(imported.warnings, Contains(HasSubstr("2 files beside it are empty (s113.dcm, s114.dcm)")));
}

TEST(LostFiles, AnEmptyOneExplainsAGap) {
  const TemporaryFolder folder;
  writeInOrder(folder.path(), makeSlices(12));
  writeBytes(folder.path() / "s105.dcm", "");
  EXPECT_THAT(faultOf(folder.path()), HasSubstr("1 file beside it is empty (s105.dcm)"));
}

/// A DICOMDIR that lists `files` (parts separated by backslashes).
std::string directoryOf(const std::vector<std::string>& files) {
  std::vector<DataSetBytes> records;
  for (const std::string& file : files)
    records.push_back(
        DataSetBytes(explicitLittle()).raw(0x00041430, "CS", "IMAGE").raw(0x00041500, "CS", file));
  DataSetBytes body(explicitLittle());
  body.raw(0x00041130, "CS", "DISC").sequence(0x00041220, records);
  DataSetBytes meta(explicitLittle());
  meta.raw(0x00020002, "UI", "1.2.840.10008.1.3.10").raw(0x00020010, "UI", "1.2.840.10008.1.2.1");
  DataSetBytes length(explicitLittle());
  length.raw(0x00020000, "UL", length.encoded(std::uint32_t(meta.bytes().size()), 4));
  return std::string(128, '\0') + "DICM" + length.bytes() + meta.bytes() + body.bytes();
}

TEST(LostFiles, WhatADicomdirListsAndIsNotThereIsCounted) {
  const TemporaryFolder folder;
  std::vector<std::string> listed;
  const auto slices = makeSlices(12);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const std::string name = "S" + std::to_string(101 + k);
    // A CD mounted with small letters, and with versions.
    if (k < 10)
      writeBytes(folder.path() / "dicom" / (k % 2 ? "s" + name.substr(1) : name + ";1"),
                 sliceFile(slices[k]));
    listed.push_back("DICOM\\" + name);
  }
  writeBytes(folder.path() / "DICOMDIR", directoryOf(listed));
  for (const auto& input : {folder.path(), folder.path() / "DICOMDIR"}) {
    const auto imported = import(input);
    EXPECT_EQ(imported.volume.grid.size[2], 10);
    EXPECT_THAT(imported.warnings, Contains(HasSubstr("2 files that the DICOMDIR lists are not there")));
  }
}

TEST(LostFiles, HeadersThatSpeakOfMoreImagesAreBelieved) {
  const TemporaryFolder folder;
  auto slices = makeSlices(12, {}, [](Slice& s, int) { s.stated_images = 12; });
  writeInOrder(folder.path() / "whole", slices);
  writeInOrder(folder.path() / "cut", {slices.begin() + 4, slices.end()});
  EXPECT_THAT(import(folder.path() / "whole").warnings, Each(Not(HasSubstr("not here"))));
  const auto cut = import(folder.path() / "cut");
  EXPECT_THAT(cut.warnings, Contains(HasSubstr("4 of the 12 images that its headers speak of are not here")));
  EXPECT_FALSE(cut.series->is_fit_for_navigation);
}

std::vector<Slice> withPhaseAt(const std::function<bool(int)>& isPhase) {
  return makeSlices(20, {}, [&](Slice& s, int k) {
    if (isPhase(k)) s.image_type = "ORIGINAL\\PRIMARY\\P";
  });
}

TEST(MixedImages, PhaseAmongMagnitudeIsNamedNotMissing) {
  const TemporaryFolder folder;
  writeInOrder(folder.path(), withPhaseAt([](int k) { return k == 5 || k == 6 || k == 14; }));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 2u);
  const auto& magnitude = series[0].is_magnitude_part ? series[0] : series[1];
  EXPECT_FALSE(magnitude.is_loadable);
  EXPECT_THAT(magnitude.problem,
              HasSubstr("3 of the 20 images of this series are of another kind (phase image)"));
  EXPECT_THAT(magnitude.problem, Not(HasSubstr("missing")));
}

TEST(MixedImages, PhaseAtAnEndIsNamedToo) {
  const TemporaryFolder folder;
  writeInOrder(folder.path(), withPhaseAt([](int k) { return k >= 17; }));
  const auto series = list(folder.path());
  ASSERT_EQ(series.size(), 2u);
  const auto& magnitude = series[0].is_magnitude_part ? series[0] : series[1];
  EXPECT_THAT(magnitude.notes, Contains(HasSubstr("3 of the 20 images of this series are of another kind")));
}

TEST(BrightAndDark, Monochrome1IsReadWithDarkAir) {
  const auto disc = [](Slice& s, int) {
    for (int j = 0; j < s.rows; ++j)
      for (int i = 0; i < s.columns; ++i)
        s.values[std::size_t(j * s.columns + i)] = std::hypot(j - 12, i - 10) < 7 ? 1000 + 10 * i : 3 * i;
  };
  const auto plain = makeSlices(12, {}, disc);
  const auto expected = properVolume(plain);
  const auto inverted = makeSlices(12, {}, [&](Slice& s, int k) {
    disc(s, k);
    s.photometric = "MONOCHROME1";
    for (int& value : s.values) value = 1190 - value;  // the brightest of the disc
  });
  const TemporaryFolder folder;
  writeInOrder(folder.path() / "inverted", inverted);
  const auto read = import(folder.path() / "inverted");
  EXPECT_EQ(read.volume.at(10, 12, 6) - read.volume.at(0, 0, 6),
            expected.at(10, 12, 6) - expected.at(0, 0, 6));
  EXPECT_LT(read.volume.at(0, 0, 6), read.volume.at(10, 12, 6));
  EXPECT_THAT(read.warnings, Contains(HasSubstr("MONOCHROME1")));
  writeInOrder(folder.path() / "mislabelled", makeSlices(12, {}, [&](Slice& s, int k) {
                 disc(s, k);
                 s.photometric = "MONOCHROME1";
               }));
  EXPECT_EQ(import(folder.path() / "mislabelled").volume.voxels, expected.voxels)
      << "its air is dark already";
}

TEST(OddSeries, CommasForDecimalPointsAreNamed) {
  const TemporaryFolder folder;
  writeInOrder(folder.path(), makeSlices(6, {}, [](Slice& s, int k) {
                 s.position_words = "-100,5\\-80,25\\" + std::to_string(k) + ",5";
               }));
  EXPECT_THAT(faultOf(folder.path()), HasSubstr("Image Position (Patient) is not 3 numbers, it has commas"));
}

TEST(OddSeries, AnIdentityOfItsOwnForEachImageIsOnePatient) {
  const TemporaryFolder folder;
  const auto scattered =
      makeSlices(12, {}, [](Slice& s, int k) { s.patient_id = "ANON" + std::to_string(k); });
  writeInOrder(folder.path() / "one", scattered);
  const auto imported = import(folder.path() / "one");
  EXPECT_EQ(imported.volume.grid.size[2], 12);
  EXPECT_THAT(imported.warnings, Contains(HasSubstr("every image names another patient")));
  auto two = scattered;
  for (std::size_t k = 6; k < two.size(); ++k) two[k].patient_id = "ANON6";
  writeInOrder(folder.path() / "two", two);
  EXPECT_GT(dicom::patientCount(list(folder.path() / "two")), 1) << "somebody has several images";
}

TEST(OddSeries, ColourIsNamed) {
  const TemporaryFolder folder;
  writeInOrder(folder.path(), makeSlices(6, {}, [](Slice& s, int) { s.photometric = "PALETTE COLOR"; }));
  EXPECT_THAT(faultOf(folder.path()), HasSubstr("colour image (palette)"));
}

TEST(OddSeries, WhatIsNotDicomIsNamed) {
  const TemporaryFolder folder;
  const std::string zip("PK\x03\x04rest of an archive");
  writeBytes(folder.path() / "zip/export.zip", zip);
  EXPECT_THAT(faultOf(folder.path() / "zip"), HasSubstr("a zip archive (export.zip)"));
  EXPECT_THAT(faultOf(folder.path() / "zip/export.zip"), HasSubstr("is a zip archive; unpack it"));
  writeBytes(folder.path() / "gz/study.tar.gz", "\x1F\x8B\x08rest");
  EXPECT_THAT(faultOf(folder.path() / "gz"), HasSubstr("a gzip archive (study.tar.gz)"));
  writeBytes(folder.path() / "nifti/t1.nii", "anything");
  writeBytes(folder.path() / "nifti/truth.npz", zip);
  EXPECT_THAT(faultOf(folder.path() / "nifti"), HasSubstr("NIfTI (t1.nii)"));
  writeBytes(folder.path() / "empty/a.dcm", "");
  writeBytes(folder.path() / "empty/b.dcm", "");
  EXPECT_THAT(faultOf(folder.path() / "empty"), HasSubstr("empty files only (2 of 0 bytes)"));
  writeBytes(folder.path() / "text/a.txt", "hello");
  EXPECT_THAT(faultOf(folder.path() / "text"), HasSubstr("holds no DICOM images; give a folder"));
}

TEST(OddSeries, TheEdgeOfAVoxelIsJudgedWithRoomForRounding) {
  using volume::VoxelSize;
  EXPECT_EQ(volume::voxelSizeOf(1.2000001), VoxelSize::fine);
  EXPECT_EQ(volume::voxelSizeOf(2.0000001), VoxelSize::coarse);
  EXPECT_EQ(volume::voxelSizeOf(2.1), VoxelSize::too_coarse);
  Slice head;
  head.rows = head.columns = 100, head.thickness = 2.0000001;
  head.row_spacing = head.column_spacing = 2;
  const TemporaryFolder folder;
  writeInOrder(folder.path(), makeSlices(90, head));
  const auto info = list(folder.path()).front();
  EXPECT_TRUE(info.is_recommended) << info.fitness;
  EXPECT_THAT(info.fitness, HasSubstr("1.2 mm or finer is needed"));
}

TEST(CharacterSet, KoreanAndChineseLoseAllTheirEscapes) {
  const std::string korean = "\\ISO 2022 IR 149", chinese = "\\ISO 2022 IR 58";
  EXPECT_EQ(dicom::personNameToUtf8("Hong^Gildong=\x1B$)C\xFB\xF3^\x1B$)C\xD1\xCE\xD4\xD7", korean),
            "Hong^Gildong");
  EXPECT_EQ(dicom::personNameToUtf8("=\x1B$)C\xFB\xF3\x1B(B^\x1B$)C\xD1\xCE\xD4\xD7\x1B(B", korean),
            "\u6d2a^\u5409\u6d1e");
  EXPECT_EQ(dicom::personNameToUtf8("\x1B$)C\xC8\xAB^\x1B$)C\xB1\xE6\xB5\xBF\x1B(B", korean),
            "\ud64d^\uae38\ub3d9");
  EXPECT_EQ(dicom::personNameToUtf8("=\x1B$)A\xCD\xF5^\x1B$)A\xD0\xA1\xB6\xAB\x1B(B", chinese),
            "\u738b^\u5c0f\u4e1c");
}

}  // namespace
}  // namespace facenav::testing
