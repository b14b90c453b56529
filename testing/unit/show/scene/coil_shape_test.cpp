#include "facenav/scene/coil_shape.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"

namespace facenav::scene {
namespace {

TEST(CoilShape, LiesOutsideTheHeadWithItsHandleAlongMinusY) {
  const CoilShape coil = makeCoilShape();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (const auto& v : coil.body.vertices_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
  EXPECT_NEAR(high.z(), 0.0, 1e-6);    // contact face; +z points into the head
  EXPECT_NEAR(low.y(), -130.0, 1e-6);  // handle
  EXPECT_LT(high.y(), 60.0);
  EXPECT_NEAR(low.x(), -high.x(), 1e-6);
  EXPECT_EQ(coil.body.normals.size(), coil.body.vertices_mm.size());
}

TEST(CoilShape, MissingMeshIsAnErrorThatNamesTheFile) {
  try {
    readCoilShape("/nowhere/coil.stl");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/coil.stl"), std::string::npos);
  }
}

}  // namespace
}  // namespace facenav::scene
