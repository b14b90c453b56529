#include "facenav/efield/field_msh.h"

#include <gmock/gmock.h>

#include <fstream>

#include "support/made_field_mesh.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::efield {
namespace {

using ::testing::HasSubstr;
using testing::refusalOf;

surface::TriangleMesh tetrahedron() {
  surface::TriangleMesh mesh;
  mesh.vertices_mm = {{0, 0, 0}, {10, 0, 0.125}, {0, 10, 0}, {0, 0, 10}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

class FieldMshTest : public ::testing::Test {
 protected:
  std::string refusal(const std::string& content) const {
    const auto path = folder_.path() / "f.msh";
    std::ofstream(path, std::ios::binary) << content;
    return refusalOf([&] { readFieldMsh(path); });
  }
  testing::TemporaryFolder folder_;
};

TEST_F(FieldMshTest, ComesBackAsItWasWritten) {
  const auto path = folder_.path() / "e.msh";
  Eigen::Matrix3Xd field = Eigen::Matrix3Xd::Random(3, 4);
  writeFieldMsh(tetrahedron(), field, path);
  const auto read = readFieldMsh(path);
  ASSERT_EQ(read.field.cols(), 4);
  EXPECT_EQ(read.field, field);
  EXPECT_EQ(read.points_mm(2, 1), 0.125);
  EXPECT_NEAR(read.magnitude[2], field.col(2).norm(), 1e-12);
}

TEST_F(FieldMshTest, ReadsTextWithDataOnElements) {
  const auto path = folder_.path() / "t.msh";
  std::ofstream(path)
      << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 3 0 0\n3 0 3 0\n4 0 0 3\n"
         "$EndNodes\n$Elements\n3\n1 2 2 1002 1002 1 2 3\n2 2 2 1005 1005 1 2 4\n"
         "3 4 2 2 2 1 2 3 4\n$EndElements\n$ElementData\n1\n\"magnE\"\n1\n0\n4\n0\n1\n3\n0\n"
         "1 7.5\n2 9\n3 8\n$EndElementData\n";
  const auto read = readFieldMsh(path);
  EXPECT_EQ(read.field.cols(), 0) << "the magnitude alone";
  ASSERT_EQ(read.magnitude.size(), 1) << "the grey matter's surface";
  EXPECT_EQ(read.magnitude[0], 7.5);
  EXPECT_NEAR((read.points_mm.col(0) - Eigen::Vector3d(1, 1, 0)).norm(), 0, 1e-12);
}

TEST_F(FieldMshTest, AHeadGivesBrainGreyMatterAndScalpWhateverTheLayout) {
  const auto field = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.z(), 1, 2); };
  facenav::testing::FieldMeshLayout layout;
  for (const bool is_binary : {true, false})
    for (const int first_id : {1, 70}) {
      layout.is_binary = is_binary, layout.first_id = first_id;
      const auto path = folder_.path() / "head.msh";
      std::ofstream(path, std::ios::binary) << facenav::testing::madeFieldMesh(layout, field);
      const auto head = readHeadFieldMsh(path);
      EXPECT_TRUE(head.fills_brain);
      EXPECT_EQ(head.scalp_mm.size(), facenav::testing::ballMesh(90).vertices_mm.size());
      ASSERT_GT(head.brain.points_mm.cols(), head.grey.points_mm.cols()) << "white matter, too";
      EXPECT_LT((head.brain.field.row(0) - head.brain.points_mm.row(2)).cwiseAbs().maxCoeff(), 1e-9);
      EXPECT_NEAR(head.brain.weight[0], 8.0 / 3, 1e-9) << "volume of a tetrahedron in a cube of 2 mm";
    }
}

TEST_F(FieldMshTest, ByteOrderAndUnknownSectionsAreMinded) {
  auto content = facenav::testing::madeFieldMesh({}, [](const Eigen::Vector3d& p) { return p; });
  const auto path = folder_.path() / "p.msh";
  const std::string names = "$PhysicalNames\n1\n3 2 \"grey\"\n$EndPhysicalNames\n";
  std::ofstream(path, std::ios::binary) << std::string(content).insert(content.find("$Nodes"), names);
  EXPECT_GT(readHeadFieldMsh(path).grey.magnitude.size(), 0);
  const std::size_t at = std::string("$MeshFormat\n2.2 1 8\n").size();
  std::swap(content[at], content[at + 3]);
  EXPECT_THAT(refusal(content), HasSubstr("byte order"));
}

TEST_F(FieldMshTest, PointsComeBackWithoutASurface) {
  FieldSamples samples;
  samples.points_mm = Eigen::Matrix3Xd::Random(3, 5);
  samples.magnitude = Eigen::VectorXd::LinSpaced(5, 1, 2);
  const auto path = folder_.path() / "points.msh";
  writeFieldPointsMsh(samples, path);
  const auto read = readFieldMsh(path);
  EXPECT_EQ(read.points_mm, samples.points_mm);
  EXPECT_EQ(read.magnitude, samples.magnitude);
  EXPECT_EQ(read.field.cols(), 0);
}

TEST_F(FieldMshTest, ReadsTheFilesMadeForThisProject) {
  const auto folder = facenav::testing::sharedData() / "interop/made";
  FACENAV_NEEDS(folder);
  for (const char* name : {"efield_binary.msh", "efield_ascii.msh"})
    EXPECT_NEAR(readFieldMsh(folder / name).magnitude.maxCoeff(), 72.944, 0.0006) << name;
}

TEST_F(FieldMshTest, DamagedFilesAreRefused) {
  EXPECT_THAT(refusal(""), HasSubstr("is no gmsh file"));
  EXPECT_THAT(refusal("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"), HasSubstr("format 2"));
  EXPECT_THAT(refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0\n"), HasSubstr("f.msh"));
  EXPECT_THAT(refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 nan\n"),
              HasSubstr("no number"));
  EXPECT_THAT(refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n-5\n"), HasSubstr("impossible number"));
  EXPECT_THAT(refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"), HasSubstr("no field named E or magnE"));
  const auto path = folder_.path() / "e.msh";
  writeFieldMsh(tetrahedron(), Eigen::Matrix3Xd::Ones(3, 4), path);
  std::ifstream stream(path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_THAT(refusal(whole.substr(0, whole.size() / 2)), HasSubstr("f.msh"));
}

}  // namespace
}  // namespace facenav::efield
