// The face is searched on heads in closed form: an ellipsoid of 75 x 95 x 115 mm, with brow, eye sockets and
// a nose at a known place, or without them.

#include "facenav/anatomy/face_match.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/anatomy/face_norms.h"

namespace facenav::anatomy {
namespace {

constexpr double kTop_mm = 115, kNasion_mm = 15;

double hill(double x, double z, double wide_mm, double high_mm) {
  return std::exp(-0.5 * (x * x / (wide_mm * wide_mm) + z * z / (high_mm * high_mm)));
}

/// Height of the face over the ellipsoid; `x` from the midline, `up` from the nasion.
double face_mm(double x, double up) {
  const double along = up > 0 ? 0 : up > -42 ? -up / 42 : std::max(0.0, 1 + (up + 42) / 6);
  const double nose = 24 * along * std::exp(-0.5 * x * x / 81);
  const double brow = 5 * hill(x, up - 10, 45, 6);
  const double sockets = 9 * (hill(x - 30, up + 6, 11, 8) + hill(x + 30, up + 6, 11, 8));
  return nose + brow - sockets;
}

SkinRelief frontOf(double scale, double aside_mm, double nod, bool has_face) {
  SkinRelief relief;
  relief.left_mm = -74, relief.bottom_mm = -95, relief.columns = 149, relief.rows = 211;
  for (int row = 0; row < relief.rows; ++row)
    for (int column = 0; column < relief.columns; ++column) {
      const double x = relief.left_mm + column, z = relief.bottom_mm + row;
      const double rest = 1 - x * x / (75.0 * 75) - z * z / (115.0 * 115);
      const double face = has_face ? scale * face_mm((x - aside_mm) / scale, (z - kNasion_mm) / scale) : 0;
      relief.height_mm.push_back(rest > 0 ? float(95 * std::sqrt(rest) + nod * z + face) : SkinRelief::kNone);
    }
  return relief;
}

TEST(FaceMatch, FindsTheFaceItsPlaceAndItsSize) {
  for (const double scale : {0.8, 1.0, 1.1})
    for (const double aside_mm : {-4.0, 0.0})
      for (const double nod : {-0.2, 0.0, 0.2}) {
        const auto face = findFace(frontOf(scale, aside_mm, nod, true), kTop_mm);
        ASSERT_TRUE(face);
        EXPECT_GT(face->likeness, kClearFaceLikeness) << scale << " " << nod;
        EXPECT_NEAR(face->x_mm, aside_mm, 1.5);
        EXPECT_NEAR(face->nasion_mm, kNasion_mm, 6.0) << scale << " " << nod;
        EXPECT_NEAR(face->scale, scale, 0.12);
        EXPECT_NEAR(face->aboveNasion_mm(face->nasion_mm - 40 * face->scale), -40, 1e-9);
      }
}

TEST(FaceMatch, AHeadWithoutAFaceIsNotLikeOne) {
  const auto none = findFace(frontOf(1, 0, 0, false), kTop_mm);
  EXPECT_LT(none ? none->likeness : 0.0, kFaceLikeness.low);
}

TEST(FaceMatch, SkinThatEndsAboveTheFaceHasNone) {
  SkinRelief relief = frontOf(1, 0, 0, true);
  for (int row = 0; row < int(kTop_mm - 50 - relief.bottom_mm); ++row)
    for (int column = 0; column < relief.columns; ++column)
      relief.height_mm[std::size_t(row) * relief.columns + column] = SkinRelief::kNone;
  EXPECT_FALSE(findFace(relief, kTop_mm));
}

TEST(FineRelief, IsTheRootMeanSquareOfFineWavesOnly) {
  for (const double period_mm : {6.0, 60.0}) {
    SkinRelief relief = frontOf(1, 0, 0, false);
    for (int row = 0; row < relief.rows; ++row)
      for (int column = 0; column < relief.columns; ++column) {
        float& height = relief.height_mm[std::size_t(row) * relief.columns + column];
        if (height > SkinRelief::kNone) height = float(2 * std::sin(2 * M_PI * row / period_mm));
      }
    const auto fine = fineRelief_mm(relief, {Eigen::Vector2d(-30, -30), Eigen::Vector2d(30, 30)});
    ASSERT_TRUE(fine);
    EXPECT_NEAR(*fine, period_mm < 10 ? 2 / std::sqrt(2.0) : 2 / std::sqrt(2.0) * 0.13, 0.08);
  }
  EXPECT_FALSE(fineRelief_mm(frontOf(1, 0, 0, false), {Eigen::Vector2d(0, 0), Eigen::Vector2d(5, 5)}));
}

}  // namespace
}  // namespace facenav::anatomy
