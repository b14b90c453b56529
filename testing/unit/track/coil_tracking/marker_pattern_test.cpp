// Decoding of the print: drawn markers in all rotations, mirrored, inverted, in uneven light; the print's
// edges.

#include "marker_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "square_homography.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::coil_tracking {
namespace {

using facenav::testing::EigenNear;

MarkerPattern pattern(int id = 7) {
  MarkerModel model;
  model.id = id;
  return MarkerPattern::load(model);
}

/// Draws the print upright, 20 px a cell, with its black square at (60, 60); `black` and `white`: grey
/// levels.
cv::Mat drawn(const cv::Mat_<float>& cells, int black = 30, int white = 210) {
  const int cell = 20, side = cells.rows * cell;
  cv::Mat image(side + 120, side + 120, CV_8U, cv::Scalar(white));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      image.at<std::uint8_t>(y + 60, x + 60) =
          std::uint8_t(black + cells(y / cell, x / cell) * float(white - black) + 0.5f);
  return image;
}

/// Corners of the square in such a picture, the `first` one first. Edges lie half a pixel before the first
/// pixel.
Quad corners(const cv::Mat& image, int first = 0) {
  const double low = 59.5, high = image.cols - 60.5;
  const std::array<Eigen::Vector2d, 4> all{{{low, low}, {high, low}, {high, high}, {low, high}}};
  Quad quad;
  for (int i = 0; i < 4; ++i) quad[std::size_t(i)] = all[std::size_t((i + first) % 4)];
  return quad;
}

TEST(MarkerPattern, IsReadInAllFourRotationsAndSaysWhichCornerIsTheFirst) {
  for (const int id : {0, 7, 23}) {
    const auto marker = pattern(id);
    const cv::Mat image = drawn(marker.cells());
    for (int first = 0; first < 4; ++first) {
      const auto match = marker.match(image, corners(image, first));
      ASSERT_TRUE(match) << id << ", " << first;
      EXPECT_EQ(match->turns, (4 - first) % 4) << "that corner of the quadrangle is the print's top left";
      EXPECT_GT(match->likeness, 0.99);
      EXPECT_NEAR(match->contrast, 180, 2);
    }
  }
}

TEST(MarkerPattern, ATurnedPictureGivesTheTurn) {
  const auto marker = pattern();
  cv::Mat turned;
  cv::rotate(drawn(marker.cells()), turned,
             cv::ROTATE_90_CLOCKWISE);  // the print's top left is now top right
  const auto match = marker.match(turned, corners(turned));
  ASSERT_TRUE(match);
  EXPECT_EQ(match->turns, 1);
}

TEST(MarkerPattern, IsNoOtherIdNoMirrorImageAndNoNegative) {
  const auto marker = pattern();
  for (const int id : {0, 1, 5, 6, 8, 49}) {
    const cv::Mat other = drawn(pattern(id).cells());
    EXPECT_FALSE(marker.match(other, corners(other))) << id;
  }
  cv::Mat mirror;
  cv::flip(drawn(marker.cells()), mirror, 1);
  EXPECT_FALSE(marker.match(mirror, corners(mirror)));
  const cv::Mat negative = 255 - drawn(marker.cells());
  EXPECT_FALSE(marker.match(negative, corners(negative)));
}

TEST(MarkerPattern, IsNoPlainSquareAndNotReadFromAFlatOrDimPicture) {
  const auto marker = pattern();
  const cv::Mat square = drawn(cv::Mat_<float>::zeros(6, 6));
  EXPECT_FALSE(marker.match(square, corners(square)));
  const cv::Mat flat(240, 240, CV_8U, cv::Scalar(120));
  EXPECT_FALSE(marker.match(flat, corners(flat)));
  const cv::Mat dim = drawn(marker.cells(), 50, 60), enough = drawn(marker.cells(), 50, 65);
  EXPECT_FALSE(marker.match(dim, corners(dim))) << "10 grey levels: below the least contrast of 12";
  EXPECT_TRUE(marker.match(enough, corners(enough)));
}

TEST(MarkerPattern, OneFlippedCellIsAnotherMarker) {
  const auto marker = pattern();
  for (const auto& [row, column] : {std::pair(1, 1), {2, 3}, {4, 4}}) {
    cv::Mat_<float> cells = marker.cells().clone();
    cells(row, column) = 1 - cells(row, column);
    const cv::Mat image = drawn(cells);
    EXPECT_FALSE(marker.match(image, corners(image))) << row << ", " << column;
  }
}

TEST(MarkerPattern, LightFromTheSideChangesNothing) {
  const auto marker = pattern();
  cv::Mat image = drawn(marker.cells());
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      auto& grey = image.at<std::uint8_t>(y, x);
      grey = std::uint8_t(grey * (0.35 + 0.65 * x / image.cols));
    }
  const auto match = marker.match(image, corners(image, 3));
  ASSERT_TRUE(match);
  EXPECT_EQ(match->turns, 1);
  EXPECT_GT(match->likeness, 0.98);
}

TEST(MarkerPattern, ASquareThatLeavesThePictureIsNotRead) {
  const auto marker = pattern();
  const cv::Mat image = drawn(marker.cells());
  Quad quad = corners(image);
  quad[2] = {image.cols + 5.0, image.rows + 5.0};
  EXPECT_FALSE(marker.match(image, quad));
  quad[2] = {-1, 50};
  EXPECT_FALSE(marker.match(image, quad));
}

TEST(MarkerPattern, ItsEdgesHaveBlackOnTheirRightAndWhiteOnTheirLeft) {
  for (const int id : {0, 7}) {
    const auto marker = pattern(id);
    const auto& cells = marker.cells();
    const int n = marker.cellsPerSide();
    const auto isWhite = [&](const Eigen::Vector2d& p) {
      const int column = int(std::floor((p.x() + 0.5) * n)), row = int(std::floor((p.y() + 0.5) * n));
      if (row < 0 || column < 0 || row >= n || column >= n) return true;
      return cells(row, column) > 0.5f;
    };
    double length = 0;
    for (const auto& edge : marker.edges()) {
      const Eigen::Vector2d along = edge.b - edge.a, d = along.normalized(), right(-d.y(), d.x());
      for (double t = 0.05; t < 1; t += 0.1) {
        EXPECT_FALSE(isWhite(edge.a + t * along + 0.25 / n * right)) << id;
        EXPECT_TRUE(isWhite(edge.a + t * along - 0.25 / n * right)) << id;
        EXPECT_FALSE(isWhite(edge.a + t * along + (edge.black_depth - 0.25 / n) * right))
            << "as deep as stated";
      }
      length += along.norm() * n;
    }
    int boundaries = 4 * n;  // the outline, then each pair of unlike neighbours
    for (int y = 0; y < n; ++y)
      for (int x = 0; x + 1 < n; ++x)
        boundaries += (cells(y, x) != cells(y, x + 1)) + (cells(x, y) != cells(x + 1, y));
    EXPECT_NEAR(length, boundaries, 1e-6) << "each boundary once";
  }
}

TEST(MarkerPattern, UnknownDictionariesAndIdsAreErrors) {
  MarkerModel model;
  for (const int id : {-1, 50, 100000}) {
    model.id = id;
    EXPECT_THROW(MarkerPattern::load(model), Error) << id;
  }
  model.id = 49;
  EXPECT_EQ(MarkerPattern::load(model).cellsPerSide(), 6) << "4 x 4 and a border";
  model.dictionary = "4x5_50";
  EXPECT_THROW(MarkerPattern::load(model), Error);
}

std::string pattText(int count, double value = 100, double other = 200) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += std::to_string(i % 16 < 6 ? value : other) + (i % 16 == 15 ? "\n" : " ");
  return text;
}

TEST(PattFile, HasFourBlocksOfThreePlanesOf16By16Numbers) {
  const facenav::testing::TemporaryFolder folder;
  MarkerModel model;
  model.pattern = folder.path() / "marker.patt";
  const auto load = [&](const std::string& text) {
    std::ofstream(*model.pattern) << text;
    return MarkerPattern::load(model);
  };
  const auto good = load(pattText(3072, 0, 255));
  EXPECT_FALSE(good.isBinary());
  EXPECT_EQ(good.cellsPerSide(), 32);
  EXPECT_NEAR(good.cells()(8, 8), 0, 1e-6) << "the middle half holds the picture";
  EXPECT_NEAR(good.cells()(8, 20), 1, 1e-6);
  EXPECT_EQ(good.cells()(7, 20), 0.f) << "the border is black";
  EXPECT_EQ(good.edges().size(), 4u) << "only the outline has known edges";
  EXPECT_THROW(load(pattText(3071)), Error);
  EXPECT_THROW(load(pattText(3073)), Error);
  EXPECT_THROW(load(pattText(3072, -1)), Error);
  EXPECT_THROW(load(pattText(3072, 100, 256)), Error);
  EXPECT_THROW(load(pattText(3072, 100, 100)), Error) << "all of one grey";
  EXPECT_THROW(load("12 twelve"), Error);
  EXPECT_THROW(load(""), Error);
  model.pattern = folder.path() / "none.patt";
  EXPECT_THROW(MarkerPattern::load(model), Error);
}

TEST(SquareHomography, CarriesCornersToCornersAndTheMiddleToTheDiagonalsCrossing) {
  const Quad quad{{{102, 55}, {240, 80}, {221, 190}, {90, 160}}};
  const SquareHomography map(quad);
  EXPECT_THAT(map(-0.5, -0.5), EigenNear(quad[0], 1e-9));
  EXPECT_THAT(map(0.5, -0.5), EigenNear(quad[1], 1e-9));
  EXPECT_THAT(map(0.5, 0.5), EigenNear(quad[2], 1e-9));
  EXPECT_THAT(map(-0.5, 0.5), EigenNear(quad[3], 1e-9));
  Eigen::Matrix2d lines;
  lines << quad[2] - quad[0], quad[1] - quad[3];
  const Eigen::Vector2d t = lines.inverse() * (quad[1] - quad[0]);
  EXPECT_THAT(map(0, 0), EigenNear(Eigen::Vector2d(quad[0] + t.x() * (quad[2] - quad[0])), 1e-9));
}

TEST(SquareHomography, KeepsStraightLinesStraight) {
  const SquareHomography map(Quad{{{102, 55}, {240, 80}, {221, 190}, {90, 160}}});
  const Eigen::Vector2d a = map(-0.4, 0.1), b = map(0.1, 0.2), c = map(0.35, 0.25);
  const Eigen::Vector2d ab = b - a, ac = c - a;
  EXPECT_NEAR(ab.x() * ac.y() - ab.y() * ac.x(), 0, 1e-8);
}

TEST(SquareHomography, BilinearValuesOfALinearPictureAreExact) {
  cv::Mat image(10, 12, CV_8U);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 12; ++x) image.at<std::uint8_t>(y, x) = std::uint8_t(10 * x + 3 * y);
  EXPECT_NEAR(bilinear(image, 4.25, 6.5), 42.5 + 19.5, 1e-9);
  EXPECT_TRUE(isInside(image, 0, 0));
  EXPECT_FALSE(isInside(image, 11, 5)) << "the next pixel would be outside";
  EXPECT_FALSE(isInside(image, 3, -0.01));
}

}  // namespace
}  // namespace facenav::coil_tracking
