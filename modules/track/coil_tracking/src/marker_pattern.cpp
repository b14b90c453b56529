#include "marker_pattern.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <opencv2/aruco.hpp>
#include <sstream>

#include "facenav/cameras/marker_dictionary.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/normal_equations.h"
#include "square_homography.h"

namespace facenav::coil_tracking {
namespace {

constexpr int kPattSamples = 16;              // ARToolKit's AR_PATT_SIZE
constexpr double kLeastContrast_grey = 12.0;  // noise of a lower contrast looks like a pattern
constexpr double kLeastLikeness = 0.6;
constexpr double kLeastTurnMargin = 0.08;  // least lead of a grey pattern's match over its own rotations

cv::Mat_<float> dictionaryCells(const std::string& name, int id) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cameras::predefinedDictionary(name));
  const int count = dictionary->bytesList.rows;
  if (id < 0 || id >= count)
    throw Error("marker id " + std::to_string(id) + " is not in dictionary " + name, {},
                "choose 0 to " + std::to_string(count - 1));
  const cv::Mat bits = cv::aruco::Dictionary::getBitsFromByteList(dictionary->bytesList.rowRange(id, id + 1),
                                                                  dictionary->markerSize);
  cv::Mat_<float> cells = cv::Mat_<float>::zeros(bits.rows + 2, bits.cols + 2);
  for (int y = 0; y < bits.rows; ++y)
    for (int x = 0; x < bits.cols; ++x) cells(y + 1, x + 1) = bits.at<uchar>(y, x) ? 1.f : 0.f;
  return cells;
}

/// 4 blocks (the pattern in four rotations) of 3 colour planes (B, G, R) of 16 x 16 numbers. Only the first
/// block is used.
cv::Mat_<float> pattCells(const std::filesystem::path& path) {
  std::istringstream stream(readWholeFile(path));
  std::vector<double> values;
  for (double value; stream >> value;) values.push_back(value);
  const std::size_t plane = kPattSamples * kPattSamples;
  if (!stream.eof() || values.size() != 4 * 3 * plane)
    throw Error("is no ARToolKit pattern (4 x 3 x 16 x 16 numbers were expected)", path.string());
  if (std::any_of(values.begin(), values.end(), [](double v) { return v < 0 || v > 255; }))
    throw Error("is no ARToolKit pattern (a number outside 0..255)", path.string());
  cv::Mat_<float> cells = cv::Mat_<float>::zeros(2 * kPattSamples, 2 * kPattSamples);
  for (int y = 0; y < kPattSamples; ++y)
    for (int x = 0; x < kPattSamples; ++x) {
      const std::size_t at = y * kPattSamples + x;
      const double grey = 0.114 * values[at] + 0.587 * values[plane + at] + 0.299 * values[2 * plane + at];
      cells(y + kPattSamples / 2, x + kPattSamples / 2) = float(grey / 255.0);
    }
  double low = 0, high = 0;
  const cv::Range middle(kPattSamples / 2, kPattSamples / 2 + kPattSamples);  // without the black border
  cv::minMaxLoc(cells(middle, middle), &low, &high);
  if (high - low < 0.1) throw Error("holds no pattern (it is all of one grey)", path.string());
  return cells;
}

/// The pattern's cell (row, column) under cell (y, x) of the quadrangle if its corner `turns` is the print's
/// top left.
float turned(const cv::Mat_<float>& cells, int y, int x, int turns) {
  const int last = cells.rows - 1;
  switch (turns & 3) {
    case 0:
      return cells(y, x);
    case 1:
      return cells(last - x, y);
    case 2:
      return cells(last - y, last - x);
    default:
      return cells(x, last - y);
  }
}

struct Cell {
  double x, y, grey;  // position of the centre, -.5..+.5
  int row, column;
};

/// Mean grey of the middle of each cell; empty if the quadrangle leaves the image.
std::vector<Cell> sampleCells(const cv::Mat& grey, const Quad& quad, int count) {
  for (const auto& corner : quad)
    if (!isInside(grey, corner.x(), corner.y())) return {};
  const SquareHomography to_pixel(quad);
  const int fine = count <= 16 ? 3 : 1;
  std::vector<Cell> cells;
  cells.reserve(std::size_t(count) * count);
  for (int row = 0; row < count; ++row)
    for (int column = 0; column < count; ++column) {
      Cell cell{(column + 0.5) / count - 0.5, (row + 0.5) / count - 0.5, 0.0, row, column};
      for (int j = 0; j < fine; ++j)
        for (int i = 0; i < fine; ++i) {
          const double step = 0.2 / count;
          const Eigen::Vector2d p = fine == 1 ? to_pixel(cell.x, cell.y)
                                              : to_pixel(cell.x + (i - 1) * step, cell.y + (j - 1) * step);
          if (!isInside(grey, p.x(), p.y())) return {};
          cell.grey += bilinear(grey, p.x(), p.y()) / (fine * fine);
        }
      cells.push_back(cell);
    }
  return cells;
}

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Least-squares fit of grey = (1, x, y) . black + t (1, x, y) . contrast.
struct LightFit {
  Vector6 parameters = Vector6::Zero();
  double likeness = 0;
  double contrast(double x, double y) const { return parameters.tail<3>().dot(Eigen::Vector3d(1, x, y)); }
  double value(double x, double y, double t) const {
    return parameters.head<3>().dot(Eigen::Vector3d(1, x, y)) + t * contrast(x, y);
  }
};

LightFit fitLight(const std::vector<Cell>& samples, const cv::Mat_<float>& cells, int turns) {
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6 right = Vector6::Zero();
  double squares = 0;
  for (const Cell& cell : samples) {
    const double t = turned(cells, cell.row, cell.column, turns);
    Vector6 basis;
    basis << 1, cell.x, cell.y, t, t * cell.x, t * cell.y;
    normal.selfadjointView<Eigen::Lower>().rankUpdate(basis);
    right += basis * cell.grey;
    squares += cell.grey * cell.grey;
  }
  normal.triangularView<Eigen::StrictlyUpper>() = normal.transpose();
  LightFit fit;
  fit.parameters = solveSymmetric(normal, right);
  const Eigen::Matrix3d plane_normal = normal.topLeftCorner<3, 3>();
  const Eigen::Vector3d plane_right = right.head<3>();
  const double unexplained_by_plane = squares - plane_right.dot(solveSymmetric(plane_normal, plane_right));
  const double unexplained = squares - right.dot(fit.parameters);
  fit.likeness = unexplained_by_plane > 1e-9 ? 1.0 - unexplained / unexplained_by_plane : 0.0;
  return fit;
}

bool hasContrastEverywhere(const LightFit& fit) {
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      if (fit.contrast(x, y) < kLeastContrast_grey / 2) return false;
  return fit.contrast(0, 0) >= kLeastContrast_grey;
}

/// True if every cell lies on its own side of the threshold between black and white.
bool everyCellFits(const std::vector<Cell>& samples, const cv::Mat_<float>& cells, int turns,
                   const LightFit& fit) {
  return std::all_of(samples.begin(), samples.end(), [&](const Cell& cell) {
    const double t = turned(cells, cell.row, cell.column, turns);
    return std::abs(cell.grey - fit.value(cell.x, cell.y, t)) < 0.5 * fit.contrast(cell.x, cell.y);
  });
}

/// True if the cell is white; outside the square is white.
bool isWhite(const cv::Mat_<float>& cells, int row, int column) {
  if (row < 0 || column < 0 || row >= cells.rows || column >= cells.cols) return true;
  return cells(row, column) > 0.5f;
}

/// Number of equal cells from (row, column) in direction (dy, dx). White outside is one cell.
int reach(const cv::Mat_<float>& cells, int row, int column, int dy, int dx) {
  const bool white = isWhite(cells, row, column);
  int count = 0;
  for (; row >= 0 && column >= 0 && row < cells.rows && column < cells.cols &&
         isWhite(cells, row, column) == white;
       row += dy, column += dx)
    ++count;
  return std::max(count, 1);
}

/// All boundaries between black and white along one direction; runs of equal polarity are joined.
void addEdges(const cv::Mat_<float>& cells, bool is_horizontal, std::vector<PrintedEdge>& edges) {
  const int n = cells.rows;
  const auto white = [&](int across, int along) {
    return is_horizontal ? isWhite(cells, across, along) : isWhite(cells, along, across);
  };
  const auto extent = [&](int across, int along, int step) {
    return is_horizontal ? reach(cells, across, along, step, 0) : reach(cells, along, across, 0, step);
  };
  for (int line = 0; line <= n; ++line)  // between cells line - 1 and line
    for (int start = 0; start < n;) {
      const bool first = white(line - 1, start), second = white(line, start);
      int end = start;
      double first_reach = n, second_reach = n;
      for (; end < n && white(line - 1, end) == first && white(line, end) == second; ++end) {
        first_reach = std::min<double>(first_reach, extent(line - 1, end, -1));
        second_reach = std::min<double>(second_reach, extent(line, end, 1));
      }
      if (first != second) {
        const double at = double(line) / n - 0.5, low = double(start) / n - 0.5, high = double(end) / n - 0.5;
        Eigen::Vector2d a(low, at),
            b(high,
              at);  // horizontal: the second side is black, to the right of an edge from left to right
        if (!is_horizontal) a = {at, low}, b = {at, high};
        const bool is_forward = is_horizontal ? first : second;
        if (!is_forward) std::swap(a, b);
        const double black = first ? second_reach : first_reach, light = first ? first_reach : second_reach;
        edges.push_back({a, b, black / n, light / n});
      }
      start = end;
    }
}

}  // namespace

MarkerPattern::MarkerPattern(cv::Mat_<float> cells, bool is_binary)
    : cells_(std::move(cells)), is_binary_(is_binary) {
  cv::Mat_<float> printed = cells_;
  if (!is_binary_)
    printed = cv::Mat_<float>::zeros(
        4, 4);  // only the outline has known edges; the border is a quarter of the side
  addEdges(printed, true, edges_);
  addEdges(printed, false, edges_);
  if (!is_binary_)
    for (PrintedEdge& edge : edges_) edge.black_depth = 0.25;
}

MarkerPattern MarkerPattern::load(const MarkerModel& model) {
  if (model.pattern) return MarkerPattern(pattCells(*model.pattern), false);
  return MarkerPattern(dictionaryCells(model.dictionary, model.id), true);
}

std::optional<PatternMatch> MarkerPattern::match(const cv::Mat& grey, const Quad& quad) const {
  const std::vector<Cell> samples = sampleCells(grey, quad, cells_.rows);
  if (samples.empty()) return std::nullopt;
  std::array<LightFit, 4> fits;
  for (int turns = 0; turns < 4; ++turns) fits[turns] = fitLight(samples, cells_, turns);
  int best = 0;
  for (int turns = 1; turns < 4; ++turns)
    if (fits[turns].likeness > fits[best].likeness) best = turns;
  const LightFit& fit = fits[best];
  if (fit.likeness < kLeastLikeness) return std::nullopt;
  if (!hasContrastEverywhere(fit)) return std::nullopt;
  if (is_binary_ && !everyCellFits(samples, cells_, best, fit)) return std::nullopt;
  for (int turns = 0; turns < 4; ++turns)
    if (turns != best && fits[turns].likeness > fit.likeness - kLeastTurnMargin) return std::nullopt;
  return PatternMatch{best, fit.likeness, fit.contrast(0, 0)};
}

}  // namespace facenav::coil_tracking
