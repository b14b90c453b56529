#include "facenav/surface/surface_values.h"

#include <gmock/gmock.h>

#include <cstring>
#include <fstream>

#include "facenav/core/whole_file.h"
#include "facenav/surface/mesh_files.h"
#include "support/ball_mesh.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::surface {
namespace {

using ::testing::HasSubstr;
using testing::refusalOf;

std::string bigEndian(std::uint32_t bits) {
  return {char(bits >> 24), char(bits >> 16), char(bits >> 8), char(bits)};
}

/// FreeSurfer's curv file with `each` values a vertex.
std::string curvOf(const std::vector<float>& values, int each = 1) {
  std::string content = "\xff\xff\xff" + bigEndian(std::uint32_t(values.size())) + bigEndian(8) +
                        bigEndian(std::uint32_t(each));
  for (const float value : values) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    content += bigEndian(bits);
  }
  return content;
}

std::string giftiOf(const std::string& values) {
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE GIFTI SYSTEM "http://www.nitrc.org/frs/download.php/115/gifti.dtd">
<GIFTI Version="1.0" NumberOfDataArrays="1"><DataArray Intent="NIFTI_INTENT_SHAPE"
DataType="NIFTI_TYPE_FLOAT32" ArrayIndexingOrder="RowMajorOrder" Dimensionality="1" Dim0="3"
Encoding="ASCII" Endian="LittleEndian" ExternalFileName="" ExternalFileOffset="0"><Data>)" +
         values + "</Data></DataArray></GIFTI>\n";
}

class SurfaceValuesTest : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    const auto path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }
  testing::TemporaryFolder folder_;
};

TEST_F(SurfaceValuesTest, CurvAndGiftiGiveTheirValues) {
  const std::vector<float> wanted{0.5f, 1.25f, -3};
  EXPECT_EQ(readSurfaceValues(write("lh.E.magn", curvOf(wanted))), wanted);
  const auto gifti = write("lh.shape.gii", giftiOf("0.5 1.25 -3"));
  EXPECT_EQ(readSurfaceValues(gifti), wanted);
  EXPECT_TRUE(holdsSurfaceValues(readWholeFile(gifti)));
  EXPECT_TRUE(holdsSurfaceValues(curvOf(wanted)));
  EXPECT_FALSE(holdsSurfaceValues("a text"));
}

TEST_F(SurfaceValuesTest, ASurfaceComesBackAsItWasWritten) {
  const auto path = folder_.path() / "lh.central.gii";
  const auto ball = testing::ballMesh(60);
  writeMesh(ball, MeshFormat::gifti, path);
  EXPECT_FALSE(holdsSurfaceValues(readWholeFile(path)));
  const auto read = readGiftiSurface(path);
  ASSERT_EQ(read.vertices_mm.size(), ball.vertices_mm.size());
  EXPECT_EQ(read.triangles, ball.triangles);
  EXPECT_LT((read.vertices_mm[77] - ball.vertices_mm[77]).norm(), 1e-4);
}

TEST_F(SurfaceValuesTest, DamagedAndForeignFilesAreRefused) {
  const auto whole = curvOf({1, 2, 3});
  EXPECT_THAT(refusalOf([&] { readSurfaceValues(write("a", whole.substr(0, 20))); }), HasSubstr("too early"));
  EXPECT_THAT(refusalOf([&] {
                readSurfaceValues(write("b", curvOf({1, 2, 3}, 3)));
              }),
              HasSubstr("more than one"));
  EXPECT_THAT(refusalOf([&] { readSurfaceValues(write("c", curvOf({1, NAN, 3}))); }), HasSubstr("no number"));
  EXPECT_THAT(refusalOf([&] { readSurfaceValues(write("d", "a text")); }), HasSubstr("a value a vertex"));
  EXPECT_THAT(refusalOf([&] { readGiftiSurface(write("e.gii", giftiOf("1 2 3"))); }),
              HasSubstr("no surface"));
  EXPECT_THAT(refusalOf([&] { readGiftiSurface(write("f.gii", "<GIFTI Version")); }), HasSubstr("f.gii"));
}

}  // namespace
}  // namespace facenav::surface
