// Reading any file ends in a volume or in one facenav::Error: no crash, no other exception.

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "dicom_bytes.h"
#include "facenav/core/error.h"
#include "facenav/dicom/import_volume.h"
#include "mutation.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

std::string readBytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Lists and loads; returns true if it gave a volume.
bool survives(const std::filesystem::path& input) {
  TaskMonitor monitor;
  bool has_volume = false;
  try {
    for (const auto& info : dicom::listSeries(input, monitor)) {
      EXPECT_EQ(info.is_loadable, info.problem.empty());
      EXPECT_EQ(info.is_loadable, info.problem_kind == dicom::SeriesProblem::none);
      if (!info.is_loadable) continue;
      try {
        has_volume |= !dicom::loadSeries(info, monitor).voxels.empty();
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
    dicom::importVolume(input, std::nullopt, monitor);
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
  return has_volume;
}

TEST(DamagedFiles, OddRealFilesEndInOneLine) {
  const auto folder = sharedData() / "dicom_variety/pydicom";
  FACENAV_NEEDS(folder);
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  survives(folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().string());
    survives(entry.path());
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");  // GDCM and its codecs print nothing
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

/// A scanner's raw data: half a gigabyte in one element, sparse on the disk.
TEST(DamagedFiles, RawDataOfHalfAGigabyteIsNotReadToBeListed) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "raw";
  constexpr std::uint32_t kLength = 512u << 20;
  DataSetBytes data(explicitLittle());
  data.raw(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66").raw(0x00080060, "CS", "MR");
  data.raw(0x0020000E, "UI", "1.2.3").raw(0x00291010, "OB", "");
  std::string bytes = fileOf(data);
  bytes.replace(bytes.size() - 4, 4, data.encoded(kLength, 4));
  writeBytes(path, bytes);
  std::filesystem::resize_file(path, bytes.size() + kLength);
  TaskMonitor monitor;
  const auto series = dicom::listSeries(folder.path(), monitor);
  ASSERT_EQ(series.size(), 1u);
  EXPECT_EQ(series[0].problem, "raw data, no image");
  EXPECT_EQ(series[0].problem_kind, dicom::SeriesProblem::no_volume);
}

TEST(DamagedFiles, SeededMutationsOfEverySyntax) {
  std::mt19937 random(20260101);
  const TemporaryFolder folder;
  int volumes = 0;
  for (const Syntax& syntax : {explicitLittle(), implicitLittle(), explicitBig()}) {
    Slice first;
    first.syntax = syntax;
    const auto slices = makeSlices(4, first);
    writeSlices(folder.path(), slices);
    const auto victim = folder.path() / "f7919";
    const std::string good = readBytes(victim);
    for (int trial = 0; trial < 300; ++trial) {
      SCOPED_TRACE(syntax.uid + " trial " + std::to_string(trial));
      writeBytes(victim, mutated(good, random));
      volumes += survives(folder.path());
    }
    writeBytes(victim, good);
    EXPECT_TRUE(survives(folder.path()));
  }
  EXPECT_GT(volumes, 50);  // some damage is harmless, so the trials do reach the pixels
}

struct Compressed {
  const char *name, *syntax;
  int rows, columns, bits_allocated, bits_stored;
  bool is_signed;
};
constexpr Compressed kCompressed[] = {
    {"MR_small_RLE.dcm", "1.2.840.10008.1.2.5", 64, 64, 16, 16, true},
    {"MR_small_jp2klossless.dcm", "1.2.840.10008.1.2.4.90", 64, 64, 16, 16, true},
    {"JPGExtended.dcm", "1.2.840.10008.1.2.4.51", 1024, 256, 16, 12, false},
    {"JPEGLSNearLossless_08.dcm", "1.2.840.10008.1.2.4.81", 45, 10, 8, 8, false},
};

TEST(DamagedFiles, SeededMutationsOfCompressedPixels) {
  const auto folder = sharedData() / "dicom_variety/pydicom";
  FACENAV_NEEDS(folder);
  std::mt19937 random(20260102);
  for (const Compressed& c : kCompressed) {
    Slice first;
    first.rows = c.rows;
    first.columns = c.columns;
    first.bits_allocated = c.bits_allocated;
    first.bits_stored = c.bits_stored;
    first.is_signed = c.is_signed;
    const auto files = compressedSlices(readBytes(folder / c.name), first, c.syntax, 3);
    ASSERT_EQ(files.size(), 3u) << c.name;
    const TemporaryFolder scratch;
    for (std::size_t k = 0; k < files.size(); ++k) writeBytes(scratch.path() / std::to_string(k), files[k]);
    EXPECT_TRUE(survives(scratch.path())) << c.name;  // undamaged, it is read
    for (int trial = 0; trial < 30; ++trial) {
      SCOPED_TRACE(std::string(c.name) + " trial " + std::to_string(trial));
      writeBytes(scratch.path() / "1", mutated(files[1], random));
      survives(scratch.path());
    }
  }
}

TEST(DamagedFiles, SeededMutationsOfOddHeaders) {
  const auto folder = sharedData() / "dicom_variety/pydicom";
  FACENAV_NEEDS(folder);
  std::mt19937 random(20260103);
  const TemporaryFolder scratch;
  for (const char* name :
       {"test-SR.dcm", "priv_SQ.dcm", "no_meta.dcm", "rtplan_truncated.dcm", "liver_1frame.dcm"}) {
    const std::string good = readBytes(folder / name);
    for (int trial = 0; trial < 40; ++trial) {
      SCOPED_TRACE(std::string(name) + " trial " + std::to_string(trial));
      writeBytes(scratch.path() / "in", mutated(good, random));
      survives(scratch.path() / "in");
    }
  }
}

TEST(DamagedFiles, LengthsThatLieAreRefusedBeforeAnythingIsAllocated) {
  const TemporaryFolder folder;
  Slice slice = makeSlices(1)[0];
  DataSetBytes header = headerOf(slice);
  // 4 GB of private data, declared by twelve bytes.
  const std::string lie = header.bytes() + std::string("\x09\x50\x10\x10OB\0\0\xFE\xFF\xFF\xFF", 12);
  writeBytes(folder.path() / "in", std::string(128, '\0') + "DICM" + lie);
  TaskMonitor monitor;
  EXPECT_THROW(dicom::importVolume(folder.path() / "in", std::nullopt, monitor), Error);
}

TEST(DamagedFiles, SequencesNestedWithoutEndAreRefused) {
  const TemporaryFolder folder;
  DataSetBytes deep(explicitLittle());
  for (int depth = 0; depth < 2000; ++depth) {
    DataSetBytes outer(explicitLittle());
    deep = outer.sequence(0x00081140, {deep});
  }
  writeBytes(folder.path() / "in", fileOf(deep));
  TaskMonitor monitor;
  EXPECT_THROW(dicom::listSeries(folder.path(), monitor), Error);
}

}  // namespace
}  // namespace facenav::testing
