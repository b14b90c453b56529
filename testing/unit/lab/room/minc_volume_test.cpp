#include "facenav/room/minc_volume.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "facenav/core/error.h"
#include "facenav/volume/nifti.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::room {
namespace {

void writeGz(const std::filesystem::path& path, const std::string& content) {
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, content.data(), unsigned(content.size()));
  gzclose(file);
}

const char* const kHeader = R"({"order":["xspace","zspace","yspace"],
  "xspace":{"start":10,"space_length":2,"step":-1,"direction_cosines":[1,0,0]},
  "yspace":{"start":20,"space_length":4,"step":2,"direction_cosines":[0,0.8,0.6]},
  "zspace":{"start":30,"space_length":3,"step":1.5,"direction_cosines":[0,-0.6,0.8]}})";

TEST(MincVolume, VoxelsLieWhereStartStepAndCosinesPutThem) {
  const testing::TemporaryFolder folder;
  std::string raw;
  for (int value = 0; value < 24; ++value) raw.push_back(char(200 + value));
  writeGz(folder.path() / "h.gz", kHeader);
  writeGz(folder.path() / "r.gz", raw);
  const auto volume = readMincVolume(folder.path() / "h.gz", folder.path() / "r.gz");
  ASSERT_EQ(volume.grid.count(), 24u);
  // x = 1, z = 2, y = 3 in file order is the last voxel: 10 - 1; 20 + 6 along (0, .8, .6); 30 + 3 along (0,
  // -.6, .8).
  const Eigen::Vector3d expected(9.0, 26.0 * 0.8 - 33.0 * 0.6, 26.0 * 0.6 + 33.0 * 0.8);
  EXPECT_THAT(volume.grid.toMri({3.0, 2.0, 1.0}).mm, testing::EigenNear(expected, 1e-12));
  EXPECT_EQ(volume.at(3, 2, 1), 223.f);
  EXPECT_EQ(volume.at(1, 0, 0), 201.f) << "y runs fastest";
  // File axes (y, z, x) with x reversed: the affine's determinant is negative, the anatomy is not mirrored.
  EXPECT_LT(volume.grid.mri_from_voxel.linear().determinant(), 0.0);
}

TEST(MincVolume, WrongFilesAreRefusedByName) {
  const testing::TemporaryFolder folder;
  const auto header = folder.path() / "h.gz", raw = folder.path() / "r.gz";
  EXPECT_THROW(readMincVolume(header, raw), Error);
  writeGz(header, kHeader);
  writeGz(raw, std::string(23, 'x'));
  try {
    readMincVolume(header, raw);
    FAIL() << "one voxel is missing";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("r.gz"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("24"), std::string::npos);
  }
  writeGz(header, R"({"order":["xspace","zspace"]})");
  EXPECT_THROW(readMincVolume(header, raw), Error);
  writeGz(header, R"({"order":["xspace","zspace","yspace"],"xspace":{}})");
  EXPECT_THROW(readMincVolume(header, raw), Error);
}

TEST(MincVolume, TheVirtualPatientsT1IsTheNiftiOfTheCache) {
  const auto fetched = testing::cache() / "brainbrowser";
  FACENAV_NEEDS(fetched / "structural1.mnc.raw.gz");
  FACENAV_NEEDS(testing::virtualPatientMri());
  const auto minc = readMincVolume(fetched / "structural1.mnc.header.gz", fetched / "structural1.mnc.raw.gz");
  const auto nifti = volume::readNifti(testing::virtualPatientMri()).volume;
  ASSERT_EQ(minc.grid.count(), nifti.grid.count());
  double worst = 0.0;
  for (int step = 0; step < 4000; ++step) {
    const Eigen::Vector3d ijk(step * 31 % minc.grid.size[0], step * 17 % minc.grid.size[1],
                              step * 13 % minc.grid.size[2]);
    const Eigen::Vector3d there = nifti.grid.toVoxel(minc.grid.toMri(ijk));
    const Eigen::Vector3i v = there.array().round().cast<int>();
    ASSERT_TRUE(nifti.grid.contains(v.x(), v.y(), v.z()));
    ASSERT_LT((there - v.cast<double>()).norm(), 2e-3);
    worst = std::max(worst, double(std::abs(nifti.at(v.x(), v.y(), v.z()) -
                                            minc.at(int(ijk.x()), int(ijk.y()), int(ijk.z())))));
  }
  EXPECT_EQ(worst, 0.0);
}

}  // namespace
}  // namespace facenav::room
