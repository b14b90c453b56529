#include "quad_detector.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace facenav::tracking {
namespace {

/// Darkest and brightest grey of each tile and its neighbours.
struct TileRange {
  cv::Mat low, high;
};

TileRange tileRange(const cv::Mat& grey, int tile_px) {
  const int columns = (grey.cols + tile_px - 1) / tile_px, rows = (grey.rows + tile_px - 1) / tile_px;
  cv::Mat low(rows, columns, CV_8U), high(rows, columns, CV_8U), column_low, column_high;
  for (int row = 0; row < rows; ++row) {
    const cv::Range band(row * tile_px, std::min((row + 1) * tile_px, grey.rows));
    cv::reduce(grey.rowRange(band), column_low, 0, cv::REDUCE_MIN);
    cv::reduce(grey.rowRange(band), column_high, 0, cv::REDUCE_MAX);
    for (int column = 0; column < columns; ++column) {
      const int begin = column * tile_px, end = std::min(begin + tile_px, grey.cols);
      low.at<uchar>(row, column) =
          *std::min_element(column_low.ptr<uchar>() + begin, column_low.ptr<uchar>() + end);
      high.at<uchar>(row, column) =
          *std::max_element(column_high.ptr<uchar>() + begin, column_high.ptr<uchar>() + end);
    }
  }
  TileRange range;
  cv::erode(low, range.low, cv::Mat());
  cv::dilate(high, range.high, cv::Mat());
  return range;
}

using Contour = std::vector<cv::Point>;

/// A line as a point on it and its unit direction.
struct Line {
  Eigen::Vector2d point, direction;
};

/// Least-squares line through contour[begin..end) (indices wrap), its ends left out, where corners are
/// rounded.
std::optional<Line> fitSide(const Contour& contour, int begin, int end) {
  const int size = int(contour.size()), length = (end - begin + size) % size;
  const int skip = std::max(1, length / 8);
  if (length - 2 * skip < 4) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  int count = 0;
  for (int i = begin + skip; i < begin + length - skip; ++i, ++count) {
    const Eigen::Vector2d p(contour[i % size].x, contour[i % size].y);
    mean += p;
    squares += p * p.transpose();
  }
  mean /= count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(squares / count - mean * mean.transpose());
  const Eigen::Vector2d chord(contour[end % size].x - contour[begin].x,
                              contour[end % size].y - contour[begin].y);
  Line line{mean, eigen.eigenvectors().col(1)};
  if (line.direction.dot(chord) < 0) line.direction = -line.direction;
  return line;
}

std::optional<Eigen::Vector2d> intersect(const Line& a, const Line& b) {
  Eigen::Matrix2d m;
  m << a.direction, -b.direction;
  if (std::abs(m.determinant()) < 0.1) return std::nullopt;
  return Eigen::Vector2d(a.point + a.direction * (m.inverse() * (b.point - a.point)).x());
}

double area(const Quad& quad) {
  const Eigen::Vector2d p = quad[2] - quad[0], q = quad[3] - quad[1];
  return 0.5 * (p.x() * q.y() - p.y() * q.x());  // > 0: clockwise with y down
}

bool isPlausible(const Quad& quad, double least_side_px) {
  double shortest = 1e9, longest = 0;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector2d side = quad[(i + 1) % 4] - quad[i], next = quad[(i + 2) % 4] - quad[(i + 1) % 4];
    if (side.x() * next.y() - side.y() * next.x() <= 0) return false;  // not convex, or anticlockwise
    shortest = std::min(shortest, side.norm());
    longest = std::max(longest, side.norm());
  }
  return shortest >= least_side_px && longest <= 6.0 * shortest;
}

/// Indices in the contour of its four corners, clockwise; nothing where it has no four.
std::optional<std::array<int, 4>> fourCorners(const Contour& contour, double least_side_px) {
  Contour corners;
  cv::approxPolyDP(contour, corners, std::max(1.5, 0.025 * double(contour.size())), true);
  if (corners.size() != 4 || !cv::isContourConvex(corners)) return std::nullopt;
  std::array<int, 4> indices{};
  for (int i = 0; i < 4; ++i)
    indices[i] = int(std::find(contour.begin(), contour.end(), corners[i]) - contour.begin());
  for (int i = 0; i < 4; ++i)
    if (cv::norm(corners[i] - corners[(i + 1) % 4]) < 0.8 * least_side_px) return std::nullopt;
  const cv::Point p = corners[2] - corners[0], q = corners[3] - corners[1];
  if (double(p.x) * q.y - double(p.y) * q.x < 0) std::swap(indices[1], indices[3]);
  return indices;
}

std::optional<Quad> toQuad(Contour contour, double least_side_px) {
  if (cv::contourArea(contour, true) < 0)
    std::reverse(contour.begin(), contour.end());  // clockwise with y down
  const auto corners = fourCorners(contour, least_side_px);
  if (!corners) return std::nullopt;
  std::array<Line, 4> sides;
  for (int i = 0; i < 4; ++i) {
    const auto side = fitSide(contour, (*corners)[i], (*corners)[(i + 1) % 4]);
    if (!side) return std::nullopt;
    sides[i] = *side;
    // The contour runs through centres of dark pixels, half a pixel inside the edge; outside is to the left.
    sides[i].point += 0.5 * Eigen::Vector2d(side->direction.y(), -side->direction.x());
  }
  Quad quad;
  for (int i = 0; i < 4; ++i) {
    const auto corner = intersect(sides[(i + 3) % 4], sides[i]);
    const cv::Point near = contour[(*corners)[i]];
    if (!corner || (*corner - Eigen::Vector2d(near.x, near.y)).norm() > 6.0) return std::nullopt;
    quad[i] = *corner;
  }
  if (area(quad) <= 0 || !isPlausible(quad, least_side_px)) return std::nullopt;
  return quad;
}

}  // namespace

cv::Mat binariseDark(const cv::Mat& image, const QuadOptions& options) {
  cv::Mat grey = image;
  if (options.is_smoothed) cv::blur(image, grey, {3, 3});
  const int tile_px = grey.cols * grey.rows > 1000 * 800 ? 6 : 4;
  const TileRange range = tileRange(grey, tile_px);
  cv::Mat dark(grey.size(), CV_8U);
  std::vector<uchar> threshold(std::size_t(grey.cols));
  for (int tile_row = 0; tile_row < range.low.rows; ++tile_row) {
    for (int x = 0; x < grey.cols; ++x) {
      const int low = range.low.at<uchar>(tile_row, x / tile_px),
                high = range.high.at<uchar>(tile_row, x / tile_px);
      threshold[x] = high - low < options.least_contrast_grey
                         ? 0
                         : uchar(std::lround(low + options.dark_share * (high - low)));
    }
    for (int y = tile_row * tile_px; y < std::min((tile_row + 1) * tile_px, grey.rows); ++y) {
      const uchar* in = grey.ptr<uchar>(y);
      uchar* out = dark.ptr<uchar>(y);
      for (int x = 0; x < grey.cols; ++x) out[x] = in[x] < threshold[x] ? 255 : 0;
    }
  }
  return dark;
}

std::vector<Quad> findDarkQuads(const cv::Mat& grey, const cv::Rect& window, const QuadOptions& options) {
  std::vector<Contour> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(binariseDark(grey(window), options), contours, hierarchy, cv::RETR_CCOMP,
                   cv::CHAIN_APPROX_NONE, window.tl());
  std::vector<Quad> quads;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (hierarchy[i][3] >= 0) continue;  // a hole, seen from inside
    if (double(contours[i].size()) < 3.2 * options.least_side_px) continue;
    if (const auto quad = toQuad(std::move(contours[i]), options.least_side_px)) quads.push_back(*quad);
  }
  return quads;
}

}  // namespace facenav::tracking
