#include "quad_detector.h"
#include "facenav/geometry/normal_equations.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace facenav::coil_tracking {
namespace {

/// A line as a point on it and its unit direction.
struct Line {
  Eigen::Vector2d point, direction;
};

/// Least-squares line through contour[begin..end) (indices wrap). Both ends are left out, because corners are
/// rounded.
std::optional<Line> fitSide(const Outline& contour, int begin, int end) {
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
  const PrincipalAxes<2> axes = principalAxes(Eigen::Matrix2d(squares / count - mean * mean.transpose()));
  const Eigen::Vector2d chord(contour[end % size].x - contour[begin].x,
                              contour[end % size].y - contour[begin].y);
  Line line{mean, axes.vectors.col(1)};
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

/// Indices of the contour's four corners, clockwise. Returns nothing if it does not have four.
std::optional<std::array<int, 4>> fourCorners(const Outline& contour, double least_side_px) {
  Outline corners;
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

std::optional<Quad> toQuad(const Outline& contour, double least_side_px) {
  const auto corners = fourCorners(contour, least_side_px);
  if (!corners) return std::nullopt;
  std::array<Line, 4> sides;
  for (int i = 0; i < 4; ++i) {
    const auto side = fitSide(contour, (*corners)[i], (*corners)[(i + 1) % 4]);
    if (!side) return std::nullopt;
    sides[i] = *side;
    // The contour runs through centres of dark pixels, half a pixel inside the edge. Outside is to the left.
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

FoundQuads findDarkQuads(const cv::Mat& grey, const Darkness& darkness, double least_side_px) {
  const Outlines outlines =
      outlinesOf(darkAreas(grey, darkness), std::size_t(std::ceil(3.2 * least_side_px)));
  FoundQuads found;
  found.points = outlines.points;
  for (const Outline& outline : outlines.areas)
    if (const auto quad = toQuad(outline, least_side_px)) found.quads.push_back(*quad);
  return found;
}

}  // namespace facenav::coil_tracking
