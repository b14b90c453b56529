#include "facenav/surface/vector_file.h"

#include <gmock/gmock.h>

#include "facenav/surface/mesh_files.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::surface {
namespace {

TEST(VectorFile, ComesBackAsItWasWritten) {
  const testing::TemporaryFolder folder;
  VectorSurface surface;
  surface.mesh.vertices_mm = {{0, 0, 0}, {10, 0, 0.125}, {0, 10, 0}, {0, 0, 10}};
  surface.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  surface.vectors = {{1, 2, 3}, {-4, 5, 0.5f}, {0, 0, 0}, {7, 8, 9}};
  const auto path = folder.path() / "E.vtp";
  writeVectors(surface, "E", path);
  const auto read = readVectors(path, "E");
  EXPECT_EQ(read.vectors, surface.vectors);
  EXPECT_EQ(read.mesh.vertices_mm, surface.mesh.vertices_mm);
  EXPECT_THAT(testing::refusalOf([&] { readVectors(path, "magnE"); }),
              ::testing::HasSubstr("no point data 'magnE' of three components"));
  writeMesh(surface.mesh, MeshFormat::vtp, path);
  EXPECT_THAT(testing::refusalOf([&] { readVectors(path, "E"); }), ::testing::HasSubstr("E.vtp"));
}

}  // namespace
}  // namespace facenav::surface
