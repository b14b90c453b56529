// Files made here from the formats' descriptions; nibabel, an independent program, reads the same ones.

#include "facenav/surface/tract_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/zip_file.h"
#include "facenav/surface/mesh_reader.h"
#include "support/nibabel.h"

namespace facenav::surface {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using Eigen::Vector3f;

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  std::memcpy(&bytes[at], &value, sizeof value);
}
template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Header of a grid of 100 x 120 x 90 voxels of 2 x 1.5 x 3 mm whose axes run left, back, up (LPS), origin as
/// given.
std::string trkHeader(const std::string& order, int lines, int scalars = 0, int properties = 0) {
  std::string bytes(1000, '\0');
  bytes.replace(0, 5, "TRACK");
  const std::int16_t size[3] = {100, 120, 90};
  const float voxel[3] = {2.f, 1.5f, 3.f};
  const float affine[4][4] = {{-2, 0, 0, 98}, {0, -1.5f, 0, 80}, {0, 0, 3, -60}, {0, 0, 0, 1}};
  for (std::size_t i = 0; i < 3; ++i) put(bytes, 6 + 2 * i, size[i]), put(bytes, 12 + 4 * i, voxel[i]);
  put(bytes, 36, std::int16_t(scalars)), put(bytes, 238, std::int16_t(properties));
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c) put(bytes, 440 + 4 * (4 * r + c), affine[r][c]);
  bytes.replace(948, order.size(), order);
  put(bytes, 988, std::int32_t(lines)), put(bytes, 992, std::int32_t(2)), put(bytes, 996, std::int32_t(1000));
  return bytes;
}

/// File of one line of two points, in voxel mm of the given order, with the scalars and properties of the
/// header.
std::string trkFile(const std::string& order, int scalars = 0, int properties = 0) {
  std::string bytes = trkHeader(order, 1, scalars, properties);
  append(bytes, std::int32_t(2));
  for (const Vector3f& p : {Vector3f(21, 31.5f, 61.5f), Vector3f(41, 60.75f, 31.5f)}) {
    append(bytes, p);
    for (int s = 0; s < scalars; ++s) append(bytes, 7.f);
  }
  for (int s = 0; s < properties; ++s) append(bytes, 9.f);
  return bytes;
}

fs::path write(const fs::path& folder, const std::string& name, const std::string& bytes) {
  std::ofstream(folder / name, std::ios::binary) << bytes;
  return folder / name;
}

std::vector<Vector3d> byNibabelStreamlines(const fs::path& file) {
  const testing::TemporaryFolder folder;
  const auto image = folder.path() / "unused.nii";  // the support loads an image first; tracts come second
  const std::string python = "import nibabel.streamlines as s\nt = s.load('" + file.string() +
                             "')\nfor l in t.streamlines:\n  for p in l: print(*p)\n";
  return testing::pointsByNibabel(image, python, "None");
}

void expectSame(const TractLines& tracts, const std::vector<Vector3d>& points) {
  ASSERT_EQ(tracts.points_mm.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((tracts.points_mm[i].cast<double>() - points[i]).norm(), 1e-3) << i;
}

TEST(TractFiles, TrkIsPlacedByVoxelOrderAndVoxToRas) {
  const testing::TemporaryFolder folder;
  // LPS as the affine: voxel (10, 20.5, 20), so x = 98 - 20, y = 80 - 30.75, z = -60 + 60.
  const auto same = readTracts(write(folder.path(), "a.trk", trkFile("LPS", 2, 1)));
  EXPECT_LT((same.points_mm[0] - Vector3f(78, 49.25f, 0)).norm(), 1e-4f);
  expectSame(same, byNibabelStreamlines(folder.path() / "a.trk"));
  // RAS order: x and y count from the other end: voxel (99 - 10, 119 - 20.5, 20).
  const auto flipped = readTracts(write(folder.path(), "b.TRK", trkFile("RAS")));
  EXPECT_LT((flipped.points_mm[0] - Vector3f(98 - 2 * 89, 80 - 1.5f * 98.5f, 0)).norm(), 1e-4f);
  expectSame(flipped, byNibabelStreamlines(write(folder.path(), "c.trk", trkFile("RAS"))));
  const auto third = write(folder.path(), "d.trk", trkFile("LAI"));
  expectSame(readTracts(third), byNibabelStreamlines(third));
}

TEST(TractFiles, TrkWithoutAPlaceIsRefused) {
  const testing::TemporaryFolder folder;
  std::string bytes = trkFile("LPS");
  bytes.replace(440, 64, std::string(64, '\0'));
  EXPECT_THROW(readTracts(write(folder.path(), "a.trk", bytes)), Error);
}

TEST(TractFiles, TckIsRasMillimetresAndComesBack) {
  const testing::TemporaryFolder folder;
  TractLines tracts;
  tracts.points_mm = {{-40, 10, 60}, {-41, 11, 61}, {-42, 13, 62}, {35, -20, 5}, {36, -22, 6}};
  tracts.ends = {3, 5};
  writeTck(tracts, folder.path() / "a.tck");
  const auto read = readTracts(folder.path() / "a.tck");
  ASSERT_EQ(read.ends, tracts.ends);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(read.points_mm[i], tracts.points_mm[i]);
  expectSame(read, byNibabelStreamlines(folder.path() / "a.tck"));
}

TEST(TractFiles, TckOfDoublesAndOtherByteOrder) {
  const testing::TemporaryFolder folder;
  const auto file = [&](const std::string& type, bool is_swapped) {
    std::string bytes =
        "mrtrix tracks\ncommand_history: x\ndatatype: " + type + "\ncount: 1\nfile: . 100\nEND\n";
    bytes.resize(100, '\0');
    for (double value : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, double(NAN), double(NAN), double(NAN),
                         double(INFINITY), double(INFINITY), double(INFINITY)}) {
      std::string one;
      append(one, value);
      bytes += is_swapped ? std::string(one.rbegin(), one.rend()) : one;
    }
    return readTracts(write(folder.path(), "d.tck", bytes));
  };
  for (const auto& tracts : {file("Float64LE", false), file("Float64BE", true)}) {
    ASSERT_EQ(tracts.lines(), 1u);
    EXPECT_EQ(tracts.points_mm[1], Vector3f(4, 5, 6));
  }
}

template <class T>
std::string rawOf(const std::vector<T>& values) {
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

const char* kTrxHeader = R"({"DIMENSIONS": [100, 120, 90], "VOXEL_TO_RASMM":
  [[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]], "NB_VERTICES": 3, "NB_STREAMLINES": 2})";

TEST(TractFiles, TrxIsRasMillimetresInEveryPrecision) {
  const testing::TemporaryFolder folder;
  const std::vector<float> xyz{-40, 10, 60.5f, -41, 12, 62, 30, -8, 4};
  const std::string floats = rawOf(xyz), doubles = rawOf(std::vector<double>(xyz.begin(), xyz.end()));
  // -40, 10, 60.5, -41, 12, 62, 30, -8, 4 in half precision
  const std::string halves = rawOf(
      std::vector<std::uint16_t>{0xd100, 0x4900, 0x5390, 0xd120, 0x4a00, 0x53c0, 0x4f80, 0xc800, 0x4400});
  const std::string wide = rawOf(std::vector<std::uint64_t>{0, 2}),
                    ended = rawOf(std::vector<std::uint32_t>{0, 2, 3});
  const auto read = [&](const std::string& positions, const std::string& values,
                        const std::string& offsets_name, const std::string& offsets) {
    const auto file = folder.path() / "a.trx";
    writeZip({{"header.json", kTrxHeader}, {positions, values}, {offsets_name, offsets}}, file);
    return readTracts(file);
  };
  for (const auto& tracts : {read("positions.3.float32", floats, "offsets.uint64", wide),
                             read("positions.3.float64", doubles, "offsets.uint32", ended),
                             read("positions.3.float16", halves, "offsets.uint64", wide)}) {
    ASSERT_EQ(tracts.ends, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(tracts.points_mm[0], Vector3f(-40, 10, 60.5f));
    EXPECT_EQ(tracts.points_mm[2], Vector3f(30, -8, 4));
  }
}

TEST(TractFiles, TrxDeflatedByAnotherProgram) {
  const testing::TemporaryFolder folder;
  const std::string python =
      "import zipfile, struct\nz = zipfile.ZipFile('" + (folder.path() / "a.trx").string() +
      "', 'w', zipfile.ZIP_DEFLATED)\nz.writestr('header.json', '''" + std::string(kTrxHeader) +
      "''')\nz.writestr('positions.3.float32', struct.pack('<9f', *range(9)))\n"
      "z.writestr('offsets.uint64', struct.pack('<2Q', 0, 2))\nz.close()\n";
  testing::pointsByNibabel(folder.path(), python, "None");
  const auto tracts = readTracts(folder.path() / "a.trx");
  EXPECT_EQ(tracts.points_mm[2], Vector3f(6, 7, 8));
}

TEST(TractFiles, VtkLinesAreRasUnlessTheFileSaysLps) {
  const testing::TemporaryFolder folder;
  const auto file = [](const std::string& title) {
    return "# vtk DataFile Version 3.0\n" + title +
           "\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n-40 10 60 -41 12 62 -42 14 64\nLINES 1 4\n3 0 1 2\n";
  };
  const auto ras = write(folder.path(), "a.vtk", file("tracts"));
  EXPECT_TRUE(holdsLines(ras));
  EXPECT_EQ(readTracts(ras).points_mm[1], Vector3f(-41, 12, 62));
  EXPECT_EQ(readTracts(write(folder.path(), "b.vtk", file("3D Slicer. SPACE=LPS"))).points_mm[1],
            Vector3f(41, -12, 62));
}

TEST(TractFiles, DamagedFilesAreRefusedInOneLine) {
  const testing::TemporaryFolder folder;
  TractLines tracts;
  tracts.points_mm = {{-40, 10, 60}, {-41, 11, 61}};
  tracts.ends = {2};
  writeTck(tracts, folder.path() / "a.tck");
  const std::string tck = readWholeFile(folder.path() / "a.tck"), trk = trkFile("LPS");
  const auto zipOf = [&](const ZipEntries& entries) {
    writeZip(entries, folder.path() / "whole.trx");
    return readWholeFile(folder.path() / "whole.trx");
  };
  const std::string trx = zipOf({{"header.json", kTrxHeader},
                                 {"positions.3.float32", rawOf(std::vector<float>(9, 1.f))},
                                 {"offsets.uint64", rawOf(std::vector<std::uint64_t>{0, 2})}});
  const auto refused = [&](const std::string& name, const std::string& bytes) {
    try {
      readTracts(write(folder.path(), name, bytes));
      ADD_FAILURE() << name << " of " << bytes.size() << " bytes was read";
    } catch (const Error& fault) {
      EXPECT_THAT(fault.what(), ::testing::HasSubstr(name));
      EXPECT_EQ(std::string(fault.what()).find('\n'), std::string::npos);
    }
  };
  for (std::size_t size : {std::size_t(0), std::size_t(4), tck.size() / 2, tck.size() - 12})
    refused("x.tck", tck.substr(0, size));
  for (std::size_t size : {std::size_t(0), std::size_t(999), trk.size() - 1, std::size_t(1004)})
    refused("x.trk", trk.substr(0, size));
  for (std::size_t size = 0; size < trx.size(); size += 7) refused("x.trx", trx.substr(0, size));
  refused("x.trx", zipOf({{"header.json", kTrxHeader}}));
  refused("x.vtk", "no VTK file");
  refused("missing_kind.xyz", "abc");
}

TEST(TractFiles, HundredThousandLinesComeBackWhole) {
  const testing::TemporaryFolder folder;
  TractLines tracts;
  for (int i = 0; i < 100000; ++i) {
    for (int p = 0; p < 40; ++p) tracts.points_mm.emplace_back(0.001f * float(i), float(p), 1.f);
    tracts.ends.push_back(tracts.points_mm.size());
  }
  writeTck(tracts, folder.path() / "many.tck");
  const auto begun = std::chrono::steady_clock::now();
  const auto read = readTracts(folder.path() / "many.tck");
  const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  RecordProperty("read_s", std::to_string(s));
  std::printf("100000 lines, 4 million points: %.2f s\n", s);
  EXPECT_EQ(read.lines(), 100000u);
  EXPECT_EQ(read.points_mm.back(), tracts.points_mm.back());
}

TEST(MeshReader, ReadsWhatOthersWriteAndTurnsLps) {
  const testing::TemporaryFolder folder;
  const auto ply = [&](const std::string& comment) {
    return write(
        folder.path(), "m.ply",
        "ply\nformat ascii 1.0\ncomment " + comment +
            "\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n-10 0 0\n10 0 0\n10 20 1\n-10 20 2\n"
            "4 0 1 2 3\n");
  };
  const auto ras = readMesh(ply("made here"));
  ASSERT_EQ(ras.triangles.size(), 2u);  // a square becomes two
  EXPECT_LT((ras.vertices_mm[3] - Vector3d(-10, 20, 2)).norm(), 1e-6);
  EXPECT_LT((readMesh(ply("SPACE=LPS")).vertices_mm[3] - Vector3d(10, -20, 2)).norm(), 1e-6);
  EXPECT_THROW(readMesh(write(folder.path(), "n.stl", "solid but not really")), Error);
  EXPECT_THROW(readMesh(folder.path() / "none.obj"), Error);
}

}  // namespace
}  // namespace facenav::surface
