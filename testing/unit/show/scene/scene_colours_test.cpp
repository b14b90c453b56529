// Colour scale of the cortex's distance, the coarse surface, and PNG files.

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <random>

#include "coarse_mesh.h"
#include "facenav/core/error.h"
#include "facenav/scene/cortex_picture.h"
#include "facenav/scene/png.h"
#include "support/ball_mesh.h"
#include "support/test_data.h"

namespace facenav::scene {
namespace {

TEST(DistanceColour, IsPaleAtZeroAndOneSidedBeyond) {
  const auto zero = distanceColour(0.0, 3.0);
  EXPECT_LT(std::abs(zero[0] - zero[2]), 0.05);
  EXPECT_GT(zero[0], 0.85);
  for (const double full_mm : {2.0, 5.0}) {
    double before_out = 2, before_in = 2;
    for (double mm = 0.25; mm <= full_mm; mm += 0.25) {
      const auto out = distanceColour(mm, full_mm), in = distanceColour(-mm, full_mm);
      EXPECT_LT(out[2], before_out) << "blue fades outside, at each step";
      EXPECT_LT(in[0], before_in) << "red fades inside";
      EXPECT_GT(out[0], out[2]);
      EXPECT_LT(in[0], in[2]);
      before_out = out[2], before_in = in[0];
    }
  }
}

TEST(DistanceColour, DependsOnTheShareOfTheScaleOnly) {
  EXPECT_EQ(distanceColour(1.0, 2.0), distanceColour(2.5, 5.0));
  EXPECT_EQ(distanceColour(-100.0, 2.0), distanceColour(-2.0, 2.0));
}

TEST(DistanceScale, IsAWholeMillimetreAndNeverBelowTwo) {
  surface::SurfaceDistance distance;
  const auto scale = [&](double p95_mm) {
    distance.p95_mm = p95_mm;
    return distanceScale_mm(distance);
  };
  EXPECT_EQ(scale(0.3), 2.0);
  EXPECT_EQ(scale(2.0), 2.0);
  EXPECT_EQ(scale(2.01), 3.0);
  EXPECT_EQ(scale(7.5), 8.0);
}

TEST(CoarseMesh, KeepsTheBallsVolumeAndOutwardNormals) {
  const auto fine = testing::ballMesh(60, 80, 120);
  const auto coarse = coarsened(fine, 6.0);
  ASSERT_EQ(coarse.normals.size(), coarse.vertices_mm.size());
  EXPECT_LT(coarse.triangles.size(), fine.triangles.size() / 2);
  double six_volumes = 0;
  for (const auto& t : coarse.triangles)
    six_volumes += coarse.vertices_mm[t[0]].dot(coarse.vertices_mm[t[1]].cross(coarse.vertices_mm[t[2]]));
  EXPECT_NEAR(std::abs(six_volumes) / 6, 4.0 / 3 * M_PI * 60 * 60 * 60, 0.03 * 904779);
  for (std::size_t i = 0; i < coarse.normals.size(); ++i)
    EXPECT_GT(std::abs(coarse.normals[i].dot(coarse.vertices_mm[i].normalized())), 0.9);
}

TEST(CoarseMesh, TakesTheValueOfTheNearestFineVertex) {
  const auto fine = testing::ballMesh(60, 60, 80);
  std::vector<float> height;
  for (const auto& v : fine.vertices_mm) height.push_back(float(v.z()));
  const auto coarse = coarsened(fine, 8.0);
  const auto values = valuesAtNearest(fine, height, coarse);
  ASSERT_EQ(values.size(), coarse.vertices_mm.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(values[i], coarse.vertices_mm[i].z(), 4.0) << "vertices are up to 5 mm apart";
  height.pop_back();
  EXPECT_THROW(valuesAtNearest(fine, height, coarse), std::logic_error);
}

RgbImage noise(int width, int height) {
  RgbImage image(width, height);
  std::mt19937 random(3);
  for (auto& byte : image.rgb) byte = std::uint8_t(random() & 255);
  return image;
}

TEST(Png, KeepsEveryPixelAtItsPlace) {
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  const RgbImage image = noise(37, 19);
  writePng(image, path);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* read = reader->GetOutput();
  ASSERT_EQ(read->GetDimensions()[0], 37);
  ASSERT_EQ(read->GetDimensions()[1], 19);
  for (int v = 0; v < 19; ++v)
    for (int u = 0; u < 37; ++u)
      for (int c = 0; c < 3; ++c)  // VTK counts rows from the bottom
        ASSERT_EQ(int(read->GetScalarComponentAsDouble(u, 18 - v, 0, c)), int(image.pixel(u, v)[c]));
}

TEST(Png, OfNothingOrIntoNowhereIsAnErrorAndLeavesNoFile) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(writePng({}, folder.path() / "empty.png"), Error);
  EXPECT_THROW(writePng(noise(4, 4), folder.path() / "no" / "such" / "folder.png"), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace facenav::scene
