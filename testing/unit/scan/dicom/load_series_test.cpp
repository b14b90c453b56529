#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "compare_volumes.h"
#include "dicom_bytes.h"
#include "facenav/core/error.h"
#include "facenav/dicom/import_volume.h"

namespace facenav::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

volume::Volume load(const std::filesystem::path& folder) {
  TaskMonitor monitor;
  return dicom::importVolume(folder, std::nullopt, monitor).volume;
}

volume::Volume load(const std::vector<Slice>& slices) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  return load(folder.path());
}

/// Message with which importing these slices is refused; "" if it is not.
std::string refusalOf(const std::vector<Slice>& slices) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  try {
    load(folder.path());
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

std::string fileName(int k) { return "f" + std::to_string(k * 7919 % 10007); }

TEST(LoadSeries, LpsBecomesRasAndSlicesAreOrderedByPosition) {
  Slice slice;
  slice.position = {-10, -20, 30};
  slice.row_spacing = 0.9;
  slice.column_spacing = 1.1;
  auto slices = makeSlices(6, slice);
  std::reverse(slices.begin(), slices.end());
  const volume::Volume volume = load(slices);
  ASSERT_EQ(volume.grid.size, (std::array<int, 3>{20, 24, 6}));
  // Expected by PS3.3 C.7.6.2.1.1: voxel (2, 3, 4) at LPS (-10 + 2.2, -20 + 2.7, 30 + 6).
  EXPECT_LT((volume.grid.toMri({2, 3, 4}).mm - Eigen::Vector3d(7.8, 17.3, 36)).norm(), 1e-9);
  EXPECT_EQ(volume.at(2, 3, 4), float((2 * 7 + 3 * 131 + 4 * 1009) % 4096));
  EXPECT_EQ(volume.orientation_source, "DICOM");
}

TEST(LoadSeries, RescaleIsPerSlice) {
  const auto volume = load(makeSlices(5, {}, [](Slice& s, int k) {
    s.slope = 1 + k;
    s.intercept = -k;
  }));
  for (int k = 0; k < 5; ++k)
    EXPECT_EQ(volume.at(1, 1, k), float((1 + k) * ((7 + 131 + k * 1009) % 4096) - k));
}

TEST(LoadSeries, PhilipsScaleSlopeGivesComparableValues) {
  const TemporaryFolder folder;
  const auto slices = makeSlices(5);
  for (const Slice& s : slices) {
    DataSetBytes d = headerOf(s);
    d.ds(0x00281052, {10}).ds(0x00281053, {2}).raw(0x20050010, "LO", "Philips MR Imaging DD 001");
    const float scale_slope = 0.5f;
    d.raw(0x2005100E, "FL", std::string(reinterpret_cast<const char*>(&scale_slope), 4));
    writeBytes(folder.path() / std::to_string(s.instance), fileOf(d.raw(0x7FE00010, "OW", pixelBytes(s))));
  }
  const auto volume = load(folder.path());
  EXPECT_EQ(volume.at(1, 1, 0), float(138 / 0.5 + 10 / (2 * 0.5)));  // stored / SS + RI / (RS SS)
}

TEST(LoadSeries, TwelveBitsSignedAreTwosComplementWithinTheStoredBits) {
  Slice first;
  first.is_signed = true;
  const auto extended = makeSlices(5, first);
  auto bare = extended;  // the same without sign extension into the unused bits
  for (Slice& s : bare)
    for (int& value : s.values) value &= 0xFFF;
  for (const auto& slices : {extended, bare})
    EXPECT_EQ(load(slices).at(1, 1, 1), float((7 + 131 + 1009) % 4096 - 2048));
}

TEST(LoadSeries, MissingSliceNamesItsNeighbours) {
  auto slices = makeSlices(12);
  slices.erase(slices.begin() + 5);
  EXPECT_THAT(refusalOf(slices),
              AllOf(HasSubstr("1 slice is missing between " + fileName(4) + " and " + fileName(5)),
                    Not(HasSubstr("Secret"))));
}

TEST(LoadSeries, UnequalSpacingNamesTheFile) {
  const auto slices = makeSlices(12, {}, [](Slice& s, int k) {
    if (k == 7) s.position.z() += 0.2;
  });
  EXPECT_THAT(refusalOf(slices), AllOf(HasSubstr("unequal slice spacing"), HasSubstr(fileName(7))));
}

TEST(LoadSeries, SpacingThatDriftsIsUnequal) {
  const auto slices = makeSlices(60, {}, [](Slice& s, int k) { s.position.z() += 0.0004 * k * k; });
  EXPECT_THAT(refusalOf(slices), HasSubstr("unequal slice spacing"));
}

TEST(LoadSeries, RoundedPositionsAreAccepted) {
  const auto slices =
      makeSlices(30, {}, [](Slice& s, int k) { s.position.z() = std::round(k * 1.4985 * 100) / 100; });
  EXPECT_EQ(refusalOf(slices), "");
}

TEST(LoadSeries, OneSliceOfAnotherOrientationIsNamed) {
  const auto slices = makeSlices(12, {}, [](Slice& s, int k) {
    if (k == 11) s.row = {std::cos(0.1), std::sin(0.1), 0}, s.column = {-std::sin(0.1), std::cos(0.1), 0};
  });
  EXPECT_THAT(refusalOf(slices), AllOf(HasSubstr("another orientation"), HasSubstr(fileName(11))));
}

TEST(LoadSeries, OneSliceOfAnotherMatrixIsNamed) {
  const auto slices = makeSlices(12, {}, [](Slice& s, int k) {
    if (k == 0) s.rows = 12, s.values.resize(std::size_t(12 * s.columns));
  });
  EXPECT_THAT(refusalOf(slices), AllOf(HasSubstr("another matrix"), HasSubstr(fileName(0))));
}

TEST(LoadSeries, SliceBesideTheOthersIsNamed) {
  const auto slices = makeSlices(12, {}, [](Slice& s, int k) {
    if (k == 5) s.position.x() += 3;
  });
  EXPECT_THAT(refusalOf(slices), AllOf(HasSubstr("beside the others"), HasSubstr(fileName(5))));
}

TEST(LoadSeries, GantryTiltIsRefused) {
  const auto slices = makeSlices(12, {}, [](Slice& s, int k) { s.position.y() += 0.2 * k; });
  EXPECT_THAT(refusalOf(slices), HasSubstr("gantry tilt"));
}

TEST(LoadSeries, ImpossibleGeometryIsRefused) {
  EXPECT_THAT(refusalOf(makeSlices(4, {}, [](Slice& s, int) { s.row_spacing = 0; })),
              HasSubstr("Pixel Spacing"));
  EXPECT_THAT(refusalOf(makeSlices(4, {},
                                   [](Slice& s, int) {
                                     s.row = {0, 0, 0};
                                   })),
              HasSubstr("Orientation"));
  EXPECT_THAT(refusalOf(makeSlices(4, {}, [](Slice& s, int) { s.position.x() = 1e300; })),
              HasSubstr("Position"));
}

TEST(LoadSeries, PixelDataCutOffNamesTheFile) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(12));
  const auto victim = folder.path() / fileName(3);
  std::filesystem::resize_file(victim, std::filesystem::file_size(victim) - 100);
  try {
    load(folder.path());
    FAIL() << "a truncated slice was read";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("cut off"), HasSubstr(victim.string())));
  }
}

TEST(LoadSeries, HeaderCutOffAtTheEndOfTheStackIsNoShorterVolume) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(12));
  std::filesystem::resize_file(folder.path() / fileName(11), 200);
  EXPECT_THROW(load(folder.path()), Error);
}

TEST(LoadSeries, FewerPixelsThanRowsTimesColumnsIsRefused) {
  EXPECT_THAT(refusalOf(makeSlices(12, {},
                                   [](Slice& s, int k) {
                                     if (k == 3) s.values.resize(100);
                                   })),
              AllOf(HasSubstr("bytes"), HasSubstr(fileName(3))));
}

TEST(LoadSeries, IdenticalDuplicatesAreDroppedAndSaid) {
  const TemporaryFolder folder;
  auto slices = makeSlices(12);
  writeSlices(folder.path() / "a", slices);
  writeSlices(folder.path() / "b", {slices[4], slices[5]});
  TaskMonitor monitor;
  const auto imported = dicom::importVolume(folder.path(), std::nullopt, monitor);
  EXPECT_EQ(imported.volume.grid.size[2], 12);
  EXPECT_THAT(imported.warnings, Contains(HasSubstr("2 duplicate images dropped")));
}

TEST(LoadSeries, ANiftiThatWasFittedToATemplateIsSaid) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "t1.nii";
  volume::writeNifti(load(makeSlices(12)), path);
  TaskMonitor monitor;
  const auto warnings = [&] { return dicom::importVolume(path, std::nullopt, monitor).warnings; };
  EXPECT_TRUE(warnings().empty());
  constexpr std::streamoff kSformCode = 254;  // its place in a NIfTI-1 header, a 16-bit number
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(kSformCode).put(4);  // MNI 152
  file.close();
  EXPECT_THAT(warnings(), ::testing::ElementsAre(HasSubstr("fitted to a template")));
}

TEST(LoadSeries, DifferentImagesAtOnePlaceAreRefused) {
  auto slices = makeSlices(12);
  slices.push_back(slices[4]);
  slices.back().values[7] += 1;
  EXPECT_THAT(refusalOf(slices), HasSubstr("at the same place"));
}

TEST(LoadSeries, SingleFileStandsForItsSeries) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(12));
  EXPECT_EQ(load(folder.path() / fileName(3)).grid.size[2], 12);
}

TEST(LoadSeries, NoPreambleAndNoMetaHeader) {
  for (const Syntax& syntax : {explicitLittle(), implicitLittle(), explicitBig()}) {
    SCOPED_TRACE(syntax.uid);
    const TemporaryFolder folder;
    Slice first;
    first.syntax = syntax;
    const auto slices = makeSlices(6, first);
    for (const Slice& s : slices)
      writeBytes(folder.path() / std::to_string(s.instance),
                 headerOf(s).raw(0x7FE00010, "OW", pixelBytes(s)).bytes());
    EXPECT_EQ(load(folder.path()).at(3, 2, 1), float((3 * 7 + 2 * 131 + 1009) % 4096));
  }
}

TEST(LoadSeries, BigEndianBytesTravelInWords) {
  Slice first;
  first.syntax = explicitBig();
  first.bits_allocated = first.bits_stored = 8;
  EXPECT_EQ(load(makeSlices(6, first)).at(3, 2, 1), float((3 * 7 + 2 * 131 + 1009) % 256));
}

}  // namespace
}  // namespace facenav::testing
