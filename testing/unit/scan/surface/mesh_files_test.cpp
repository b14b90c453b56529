// Other programs read the files back: VTK's own readers, and nibabel for GIFTI.

#include "facenav/surface/mesh_files.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include <cstdio>
#include <fstream>

#include "facenav/core/error.h"
#include "support/nibabel.h"
#include "support/test_data.h"

namespace facenav::surface {
namespace {

/// Mesh without symmetry, so that an exchanged axis or sign is detected.
TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices_mm = {{-61.25, 12.5, 3.125}, {70.5, 11.75, -2.0}, {5.0, 95.5, 1.25}, {4.5, 20.25, 81.0}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

double signedVolume_mm3(const std::vector<Eigen::Vector3d>& corners) {
  double six_volumes = 0;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
    six_volumes += corners[t].dot(corners[t + 1].cross(corners[t + 2]));
  return six_volumes / 6;
}

std::vector<Eigen::Vector3d> cornersOf(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> corners;
  for (const auto& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) corners.push_back(mesh.vertices_mm[t[c]]);
  return corners;
}

template <class Reader>
std::vector<Eigen::Vector3d> readCorners(const std::filesystem::path& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  std::vector<Eigen::Vector3d> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    for (vtkIdType c = 0; c < mesh->GetCell(cell)->GetNumberOfPoints(); ++c) {
      Eigen::Vector3d p;
      mesh->GetPoint(mesh->GetCell(cell)->GetPointId(c), p.data());
      corners.push_back(p);
    }
  return corners;
}

void expectSame(const std::vector<Eigen::Vector3d>& read) {
  const auto written = cornersOf(tetrahedron());
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    EXPECT_LT((read[i] - written[i]).norm(), 1e-4) << "corner " << i;
  EXPECT_NEAR(signedVolume_mm3(read), signedVolume_mm3(written), 1.0);
}

TEST(MeshFiles, VtkReadsBackStlPlyObjAndVtpInRas) {
  const testing::TemporaryFolder folder;
  const auto mesh = tetrahedron();
  ASSERT_GT(signedVolume_mm3(cornersOf(mesh)), 0.0) << "outward";
  for (const auto format : {MeshFormat::stl, MeshFormat::ply, MeshFormat::obj, MeshFormat::vtp})
    writeMesh(mesh, format, folder.path() / ("mesh" + extensionOf(format)));
  {
    SCOPED_TRACE("stl");
    expectSame(readCorners<vtkSTLReader>(folder.path() / "mesh.stl"));
  }
  {
    SCOPED_TRACE("ply");
    expectSame(readCorners<vtkPLYReader>(folder.path() / "mesh.ply"));
  }
  {
    SCOPED_TRACE("obj");
    expectSame(readCorners<vtkOBJReader>(folder.path() / "mesh.obj"));
  }
  {
    SCOPED_TRACE("vtp");
    expectSame(readCorners<vtkXMLPolyDataReader>(folder.path() / "mesh.vtp"));
  }
}

TEST(MeshFiles, StlAndPlySayThatTheyAreInRas) {
  const testing::TemporaryFolder folder;
  for (const auto format : {MeshFormat::stl, MeshFormat::ply}) {
    const auto path = folder.path() / ("mesh" + extensionOf(format));
    writeMesh(tetrahedron(), format, path);
    std::ifstream stream(path, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_THAT(content.substr(0, 200), ::testing::HasSubstr("SPACE=RAS"));
  }
}

TEST(MeshFiles, NibabelReadsBackGifti) {
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "mesh.gii";
  writeMesh(tetrahedron(), MeshFormat::gifti, path);
  expectSame(
      testing::pointsByNibabel(path,
                               "points, triangles = image.agg_data('pointset'), image.agg_data('triangle')\n"
                               "for t in triangles:\n"
                               "  for i in t: print(*(float(v) for v in points[i]))\n"
                               "space = image.get_arrays_from_intent('pointset')[0].coordsys\n"
                               "assert space.dataspace == 1, space.dataspace\n"));  // scanner anatomical
}

TEST(MeshFiles, AnEmptyMeshIsRefusedAndLeavesNoFile) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(writeMesh({}, MeshFormat::stl, folder.path() / "mesh.stl"), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace facenav::surface
