#include "quad_detector.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace facenav::tracking {
namespace {

constexpr int kTile_px = 2;

/// Darkest and brightest grey of each tile of 2 x 2 pixels and its neighbours: larger surroundings would let
/// a bright thing beside the marker's white rim make the rim count as dark.
struct TileRange {
  cv::Mat low, high;
};

/// The smaller (or larger) of each two neighbouring columns.
template <class Choose>
cv::Mat overColumnPairs(const cv::Mat& rows, Choose choose) {
  cv::Mat out(rows.rows, rows.cols / kTile_px, CV_8U);
  for (int y = 0; y < out.rows; ++y) {
    const uchar* in = rows.ptr<uchar>(y);
    uchar* to = out.ptr<uchar>(y);
    for (int x = 0; x < out.cols; ++x) to[x] = choose(in[2 * x], in[2 * x + 1]);
  }
  return out;
}

TileRange tileRange(const cv::Mat& grey) {
  const int rows = grey.rows / kTile_px;
  const std::size_t step = kTile_px * grey.step[0];
  auto* const first = const_cast<uchar*>(grey.data);  // a view of every second row; only read
  const cv::Mat even(rows, grey.cols, CV_8U, first, step),
      odd(rows, grey.cols, CV_8U, first + grey.step[0], step);
  cv::Mat low, high;
  cv::min(even, odd, low);
  cv::max(even, odd, high);
  TileRange range;
  cv::erode(overColumnPairs(low, [](uchar a, uchar b) { return std::min(a, b); }), range.low, cv::Mat());
  cv::dilate(overColumnPairs(high, [](uchar a, uchar b) { return std::max(a, b); }), range.high, cv::Mat());
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
    if (!corner || (*corner - Eigen::Vector2d(near.x, near.y)).norm() > 4.0) return std::nullopt;
    quad[i] = *corner;
  }
  if (area(quad) <= 0 || !isPlausible(quad, least_side_px)) return std::nullopt;
  return quad;
}

}  // namespace

cv::Mat binariseDark(const cv::Mat& image, const QuadOptions& options) {
  const cv::Mat grey =
      image(cv::Rect(0, 0, image.cols / kTile_px * kTile_px, image.rows / kTile_px * kTile_px));
  const TileRange range = tileRange(grey);
  cv::Mat tiles(range.low.size(), CV_8U), threshold, dark;
  const int share = int(256 * options.dark_share);
  for (int row = 0; row < tiles.rows; ++row) {
    const uchar *lows = range.low.ptr<uchar>(row), *highs = range.high.ptr<uchar>(row);
    uchar* out = tiles.ptr<uchar>(row);
    for (int column = 0; column < tiles.cols; ++column) {
      const int low = lows[column], contrast = highs[column] - low;
      out[column] = contrast < options.least_contrast_grey ? 0 : uchar(low + (share * contrast + 128) / 256);
    }
  }
  cv::resize(tiles, threshold, grey.size(), 0, 0, cv::INTER_NEAREST);
  cv::compare(grey, threshold, dark, cv::CMP_LT);
  return dark;
}

std::vector<Quad> findDarkQuads(const cv::Mat& grey, const QuadOptions& options) {
  std::vector<Contour> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(binariseDark(grey, options), contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::vector<Quad> quads;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (hierarchy[i][3] >= 0) continue;  // a hole, seen from inside
    if (double(contours[i].size()) < 3.2 * options.least_side_px) continue;
    if (const auto quad = toQuad(std::move(contours[i]), options.least_side_px)) quads.push_back(*quad);
  }
  return quads;
}

}  // namespace facenav::tracking
