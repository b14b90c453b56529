// A full disk, played by a limit on the size of files: one line, and not VTK's many.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <random>

#include "facenav/core/error.h"
#include "facenav/surface/scalp_surface.h"
#include "support/test_data.h"

namespace facenav::surface {
namespace {

ScalpSurface largeSurface() {
  ScalpSurface scalp;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place_mm(-80, 80);
  for (int v = 0; v < 20000; ++v) {
    scalp.mesh.vertices_mm.push_back({place_mm(random), place_mm(random), place_mm(random)});
    scalp.mesh.normals.push_back(Eigen::Vector3d::UnitX());
    if (v >= 2) scalp.mesh.triangles.push_back({v - 2, v - 1, v});
  }
  return scalp;
}

void writeOntoAFullDisk(const ScalpSurface& scalp, const std::filesystem::path& path) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{8192, 8192};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  try {
    writeScalp(scalp, path);
  } catch (const Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    std::_Exit(3);
  }
  std::_Exit(0);
}

TEST(FullDiskDeathTest, ASurfaceThatDoesNotFitGivesOneLine) {
  const ScalpSurface scalp = largeSurface();
  const facenav::testing::TemporaryFolder folder;
  EXPECT_EXIT(writeOntoAFullDisk(scalp, folder.path() / "scalp.vtp"), ::testing::ExitedWithCode(3),
              "^error: [^\n]*scalp.vtp[^\n]*\n$");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "scalp.vtp"));
}

}  // namespace
}  // namespace facenav::surface
