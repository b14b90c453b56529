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

std::string giftiWith(const std::string& attributes, const std::string& data) {
  return "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"1\"><DataArray Intent=\"NIFTI_INTENT_SHAPE\" "
         "DataType=\"NIFTI_TYPE_FLOAT32\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"1\" "
         "Dim0=\"3\" " +
         attributes + "><Data>" + data + "</Data></DataArray></GIFTI>";
}

TEST_F(SurfaceValuesTest, GiftiIsReadInEveryEncoding) {
  const std::vector<float> wanted{0.5f, 1.25f, -3};
  const std::string bytes("\0\0\0\x3f\0\0\xa0\x3f\0\0\x40\xc0", 12), base64 = "AAAAPwAAoD8AAEDA";
  const std::string little = " Endian=\"LittleEndian\"";
  EXPECT_EQ(readSurfaceValues(write("a.gii", giftiWith("Encoding=\"Base64Binary\"" + little, base64))),
            wanted);
  EXPECT_EQ(readSurfaceValues(write(
                "b.gii", giftiWith("Encoding=\"Base64Binary\" Endian=\"BigEndian\"", "PwAAAD+gAADAQAAA"))),
            wanted);
  write("c.dat", "head" + bytes);
  EXPECT_EQ(
      readSurfaceValues(write("c.gii", giftiWith("Encoding=\"ExternalFileBinary\" ExternalFileName=\"c.dat\" "
                                                 "ExternalFileOffset=\"4\"" +
                                                     little,
                                                 ""))),
      wanted);
}

TEST_F(SurfaceValuesTest, ADamagedGiftiFileIsRefusedWithoutALineOfTheLibrarys) {
  const std::string little = " Endian=\"LittleEndian\"";
  ::testing::internal::CaptureStderr();
  int number = 0;
  for (const std::string& content :
       {std::string("<GIFTI Version"), std::string("<GIFTI></X>"), giftiOf("1 2"), giftiOf("1 2 x"),
        giftiWith("Encoding=\"Base64Binary\"" + little, "!!!!"),
        giftiWith("Encoding=\"Base64Binary\"" + little, "AAAA"),
        giftiWith("Encoding=\"GZipBase64Binary\"" + little, "AAAA"),
        giftiWith("Encoding=\"ExternalFileBinary\" ExternalFileName=\"none\"" + little, ""),
        giftiWith("Encoding=\"Foo\"" + little, "1 2 3")}) {
    const std::string name = std::to_string(++number) + ".gii";
    EXPECT_THAT(refusalOf([&] { readSurfaceValues(write(name, content)); }), HasSubstr(name)) << content;
  }
  const auto ball = folder_.path() / "ball.gii";
  writeMesh(testing::ballMesh(60), MeshFormat::gifti, ball);
  std::string damaged = readWholeFile(ball);  // compressed; gifti_io reads such a file as zeros
  const auto middle = damaged.find("<Data>") + 200;
  for (std::size_t i = 0; i < 20; ++i) damaged[middle + i] = 'A';
  EXPECT_THAT(refusalOf([&] { readGiftiSurface(write("damaged.gii", damaged)); }), HasSubstr("damaged"));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace facenav::surface
