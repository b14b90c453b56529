#pragma once
// MarkerPattern: the print in the black square, and whether a quadrangle of an image shows it (paper,
// section 5, step 4). ArUco dictionaries: a grid of black and white cells with a border of one black cell.
// ARToolKit .patt: 16 x 16 grey values of the middle half of the square (the file's first block, three colour
// planes B, G, R), border a quarter.
//
// The match is linear in the light: grey = field of black + field of contrast * pattern. Both fields are
// planes over the marker, so that a shadow or a lamp from the side has no effect. Each cell must also lie on
// its own side of the threshold.

#include <Eigen/Core>
#include <array>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

/// Corners in the image in the order of the print: top left, top right, bottom right, bottom left.
using Quad = std::array<Eigen::Vector2d, 4>;

/// An edge between black and white on the print, in sides of the square; origin its centre, x right, y down.
/// Black lies to the right of a -> b on the print, that is on the side of (-d.y, d.x).
struct PrintedEdge {
  Eigen::Vector2d a, b;
  double black_depth, white_depth;  // extent of black and white across the edge
};

struct PatternMatch {
  int turns = 0;        // corner `turns` of the given quadrangle is the print's top left
  double likeness = 0;  // fraction of the grey values' variance that the pattern explains, 0..1
  double contrast = 0;  // grey levels between black and white
};

class MarkerPattern {
 public:
  /// Throws Error for an unknown dictionary or id, and for a .patt that is missing or not 4 x 3 x 16 x 16
  /// numbers in 0..255.
  static MarkerPattern load(const MarkerModel& model);

  /// The best of the four rotations. Returns nothing if the quadrangle does not show this pattern. `quad`:
  /// clockwise in the image.
  std::optional<PatternMatch> match(const cv::Mat& grey, const Quad& quad) const;
  const std::vector<PrintedEdge>& edges() const { return edges_; }
  /// Cells along the whole side, border included; 32 for a .patt, whose 16 samples cover the middle half.
  int cellsPerSide() const { return cells_.rows; }
  /// Grey pattern of the whole square, 0 black to 1 white, cellsPerSide x cellsPerSide.
  const cv::Mat_<float>& cells() const { return cells_; }
  bool isBinary() const { return is_binary_; }

 private:
  MarkerPattern(cv::Mat_<float> cells, bool is_binary);
  cv::Mat_<float> cells_;
  bool is_binary_;
  std::vector<PrintedEdge> edges_;
};

}  // namespace facenav::coil_tracking
