// Compares voxel values exactly, and world positions within 1e-3 mm, with an independent reader (Debian's
// dcm2niix).

#include <gtest/gtest.h>

#include "compare_volumes.h"
#include "dicom_bytes.h"
#include "enhanced_file.h"
#include "facenav/dicom/import_volume.h"

namespace facenav::testing {
namespace {

volume::Volume loadFirst(const std::filesystem::path& folder) {
  TaskMonitor monitor;
  return dicom::importVolume(folder, std::nullopt, monitor).volume;
}

void expectAgreement(const std::filesystem::path& folder) {
  const auto expected = dcm2niixVolume(folder);
  ASSERT_TRUE(expected) << "dcm2niix made no single volume";
  expectSameInWorld(loadFirst(folder), *expected);
}

void expectAgreement(const std::vector<Slice>& slices) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "in", slices);
  expectAgreement(folder.path() / "in");
}

Slice directed(const Eigen::Vector3d& row, const Eigen::Vector3d& column) {
  Slice slice;
  slice.row = row;
  slice.column = column;
  slice.row_spacing = 0.9;
  slice.column_spacing = 1.1;
  return slice;
}

TEST(Dcm2niixAgreement, RealT1Oblique) {
  FACENAV_NEEDS(t1Dicom());
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  expectAgreement(t1Dicom());
}

// The GE series' positions are rounded to 0.1 mm: its gaps are 7.07 and 6.96 mm in turn. dcm2niix continues
// the first gap and puts the last slice 1.34 mm beyond its own Image Position; here every slice lies within
// 0.06 mm of it.
TEST(Dcm2niixAgreement, RealGeAxialHasTheSameValuesAndKeepsItsPositions) {
  const auto folder = sharedData() / "dicom_variety/papaya_ge_axial";
  FACENAV_NEEDS(folder);
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  const volume::Volume actual = loadFirst(folder);
  auto expected = dcm2niixVolume(folder);
  ASSERT_TRUE(expected);
  EXPECT_EQ(volume::toRasOrder(actual).voxels, volume::toRasOrder(*expected).voxels);
  // Positions by dcmdump: brain_001, brain_011 and brain_020, LPS.
  const Eigen::Vector3d first(-110.5, -78.3063, -72.7575), middle(-110.5, -87.7063, -3.35753),
      last(-110.5, -96.2063, 59.0425);
  const Eigen::DiagonalMatrix<double, 3> ras_from_lps(-1, -1, 1);
  EXPECT_LT((actual.grid.toMri({0, 0, 0}).mm - ras_from_lps * first).norm(), 0.06);
  EXPECT_LT((actual.grid.toMri({0, 0, 10}).mm - ras_from_lps * middle).norm(), 0.1);
  EXPECT_LT((actual.grid.toMri({0, 0, 19}).mm - ras_from_lps * last).norm(), 0.06);
}

TEST(Dcm2niixAgreement, EveryAxisAlignedOrientation) {
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      for (int signs = 0; signs < 4; ++signs) {
        if (a == b) continue;
        SCOPED_TRACE(std::to_string(a) + std::to_string(b) + std::to_string(signs));
        expectAgreement(makeSlices(12, directed((signs & 1 ? -1 : 1) * Eigen::Vector3d::Unit(a),
                                                (signs & 2 ? -1 : 1) * Eigen::Vector3d::Unit(b))));
      }
}

TEST(Dcm2niixAgreement, DoublyOblique) {
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  const Eigen::Matrix3d r =
      (Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  expectAgreement(makeSlices(12, directed(r.col(0), r.col(1))));
  expectAgreement(makeSlices(12, directed(r.col(2), r.col(0))));
}

TEST(Dcm2niixAgreement, BitDepthsAndSigns) {
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  for (const bool is_signed : {false, true})
    for (const int stored : {10, 12, 14, 16}) {
      if (is_signed && stored == 12)
        continue;  // dcm2niix loses the sign there; see LoadSeries.TwelveBitsSigned
      SCOPED_TRACE(std::to_string(stored) + (is_signed ? " signed" : " unsigned"));
      Slice slice;
      slice.bits_stored = stored;
      slice.is_signed = is_signed;
      expectAgreement(makeSlices(8, slice));
    }
  Slice byte;
  byte.bits_allocated = byte.bits_stored = 8;
  expectAgreement(makeSlices(8, byte));
}

TEST(Dcm2niixAgreement, Rescale) {
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  Slice slice;
  slice.slope = 2.4401709;
  slice.intercept = -17.25;
  expectAgreement(makeSlices(8, slice));
}

/// dcm2niix keeps the stored values of MONOCHROME1, in which air is bright; here bright and dark are
/// exchanged.
TEST(Dcm2niixAgreement, Monochrome1AfterBrightAndDarkAreExchanged) {
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  Slice slice;
  slice.photometric = "MONOCHROME1";
  const auto slices = makeSlices(8, slice, [](Slice& s, int) {
    for (int& value : s.values) value = 2048 + value / 2;  // bright corners
    s.values[0] = 0;
  });
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  TaskMonitor monitor;
  const auto ours = dicom::importVolume(folder.path(), std::nullopt, monitor).volume;
  auto theirs = dcm2niixVolume(folder.path());
  ASSERT_TRUE(theirs);
  const float top = *std::max_element(theirs->voxels.begin(), theirs->voxels.end());
  for (float& value : theirs->voxels) value = top - value;
  expectSameInWorld(ours, *theirs);
}

TEST(Dcm2niixAgreement, ImplicitAndBigEndian) {
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  for (const Syntax& syntax : {implicitLittle(), explicitBig()}) {
    SCOPED_TRACE(syntax.uid);
    Slice slice;
    slice.syntax = syntax;
    expectAgreement(makeSlices(8, slice));
  }
}

/// `command` turns %1 (in) into %2 (out) for every slice.
void expectAgreementAfter(const std::string& program) {
  const TemporaryFolder folder;
  writeSlices(folder.path() / "in", makeSlices(8));
  std::filesystem::create_directory(folder.path() / "out");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "in")) {
    const auto out = folder.path() / "out" / entry.path().filename();
    ASSERT_EQ(
        std::system(
            (program + " '" + entry.path().string() + "' '" + out.string() + "' >/dev/null 2>&1").c_str()),
        0);
  }
  expectSameInWorld(loadFirst(folder.path() / "out"), loadFirst(folder.path() / "in"));
  if (const auto other = dcm2niixVolume(folder.path() / "out"))
    expectSameInWorld(loadFirst(folder.path() / "out"), *other);
}

TEST(Dcm2niixAgreement, Rle) {
  FACENAV_NEEDS_PROGRAM("dcmcrle");
  expectAgreementAfter("dcmcrle");
}

TEST(Dcm2niixAgreement, JpegLossless) {
  FACENAV_NEEDS_PROGRAM("dcmcjpeg");
  expectAgreementAfter("dcmcjpeg +e1");
  expectAgreementAfter("dcmcjpeg +el");
}

TEST(Dcm2niixAgreement, JpegLs) {
  FACENAV_NEEDS_PROGRAM("dcmcjpls");
  expectAgreementAfter("dcmcjpls");
}

/// The file's one compressed frame cut into pieces of `most_bytes` (even), each a fragment (PS3.5 A.4).
std::string withFragments(const std::string& file, std::size_t most_bytes) {
  const DataSetBytes coder(explicitLittle());
  const std::string pixels("\xE0\x7F\x10\0OB\0\0\xFF\xFF\xFF\xFF", 12), item("\xFE\xFF\x00\xE0", 4);
  const std::size_t at = file.rfind(pixels) + pixels.size();
  const auto lengthAt = [&](std::size_t i) {
    std::uint32_t length = 0;
    std::memcpy(&length, file.data() + i + 4, 4);
    return std::size_t(length);
  };
  const std::size_t frame = at + 8 + lengthAt(at);  // after the offset table
  const std::string stream = file.substr(frame + 8, lengthAt(frame));
  std::string out = file.substr(0, at) + item + coder.encoded(0, 4);
  for (std::size_t i = 0; i < stream.size(); i += most_bytes) {
    const std::string piece = stream.substr(i, most_bytes);
    out += item + coder.encoded(std::uint32_t(piece.size()), 4) + piece;
  }
  return out + std::string("\xFE\xFF\xDD\xE0\0\0\0\0", 8);
}

// dcm2niix refuses compressed images of several fragments.
TEST(Dcm2niixAgreement, FragmentedFramesAreReadWhole) {
  FACENAV_NEEDS_PROGRAM("gdcmconv");
  FACENAV_NEEDS_PROGRAM("dcmcjpeg");
  FACENAV_NEEDS_PROGRAM("dcmcjpls");
  for (const char* program : {"gdcmconv --j2k", "dcmcjpeg +e1", "dcmcjpls"}) {
    SCOPED_TRACE(program);
    const TemporaryFolder folder;
    writeSlices(folder.path() / "in", makeSlices(6));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "in")) {
      const auto whole = folder.path() / "whole";
      ASSERT_EQ(std::system((std::string(program) + " '" + entry.path().string() + "' '" + whole.string() +
                             "' >/dev/null 2>&1")
                                .c_str()),
                0);
      std::ifstream stream(whole, std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
      writeBytes(folder.path() / "out" / entry.path().filename(), withFragments(bytes, 64));
    }
    expectSameInWorld(loadFirst(folder.path() / "out"), loadFirst(folder.path() / "in"));
  }
}

// dcm2niix refuses 12-bit JPEG. It is lossy, so DCMTK's own decoder gives the expected values.
TEST(Dcm2niixAgreement, TwelveBitJpegEqualsDcmtksDecoder) {
  FACENAV_NEEDS_PROGRAM("dcmcjpeg");
  FACENAV_NEEDS_PROGRAM("dcmdjpeg");
  const TemporaryFolder folder;
  writeSlices(folder.path() / "in", makeSlices(6));
  for (const char* name : {"jpeg", "raw"}) std::filesystem::create_directory(folder.path() / name);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "in")) {
    const std::string name = entry.path().filename().string();
    const std::string command = "cd '" + folder.path().string() + "' && dcmcjpeg +ee in/" + name + " jpeg/" +
                                name + " >/dev/null 2>&1 && dcmdjpeg jpeg/" + name + " raw/" + name +
                                " >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }
  expectSameInWorld(loadFirst(folder.path() / "jpeg"), loadFirst(folder.path() / "raw"));
}

// One rescale for all frames: dcm2niix applies the first frame's to all.
TEST(Dcm2niixAgreement, EnhancedMultiFrame) {
  FACENAV_NEEDS_PROGRAM("dcm2niix");
  const TemporaryFolder folder;
  writeBytes(folder.path() / "in/a", enhancedFile({10, 1, explicitLittle(), false}));
  expectAgreement(folder.path() / "in");
}

TEST(Dcm2niixAgreement, Deflated) {
  FACENAV_NEEDS_PROGRAM("dcmconv");
  expectAgreementAfter("dcmconv +td");
}

}  // namespace
}  // namespace facenav::testing
