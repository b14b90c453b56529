#include "dark_areas.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace facenav::coil_tracking {
namespace {

constexpr int kTile_px = 2;

/// Darkest and brightest grey of each tile of 2 x 2 pixels and its neighbours. With a larger neighbourhood, a
/// bright object next to the marker's white margin would make the margin dark.
struct TileRange {
  TileRange(int rows, int columns) : low(rows, columns, CV_8U), high(rows, columns, CV_8U) {}
  cv::Mat low, high;
};

uchar lower(uchar a, uchar b) { return a < b ? a : b; }
uchar higher(uchar a, uchar b) { return a < b ? b : a; }

TileRange tilesOf(const cv::Mat& grey) {
  TileRange tiles(grey.rows / kTile_px, grey.cols / kTile_px);
  const int columns = tiles.low.cols;
  for (int row = 0; row < tiles.low.rows; ++row) {
    const uchar *even = grey.ptr<uchar>(kTile_px * row), *odd = grey.ptr<uchar>(kTile_px * row + 1);
    uchar *low = tiles.low.ptr<uchar>(row), *high = tiles.high.ptr<uchar>(row);
    for (int x = 0; x < columns; ++x) {
      low[x] = lower(lower(even[2 * x], odd[2 * x]), lower(even[2 * x + 1], odd[2 * x + 1]));
      high[x] = higher(higher(even[2 * x], odd[2 * x]), higher(even[2 * x + 1], odd[2 * x + 1]));
    }
  }
  return tiles;
}

/// Combines three rows with `choose`, then three columns; gives `columns` values. `between`: buffer of a row
/// + 2.
template <class Choose>
void overNeighbours(const std::array<const uchar*, 3>& rows, int columns, uchar* between, uchar* out,
                    Choose choose) {
  for (int x = 0; x < columns; ++x) between[x + 1] = choose(choose(rows[0][x], rows[1][x]), rows[2][x]);
  between[0] = between[1], between[columns + 1] = between[columns];
  for (int x = 0; x < columns; ++x) out[x] = choose(choose(between[x], between[x + 1]), between[x + 2]);
}

void thresholds(const uchar* low, const uchar* high, int columns, const Darkness& darkness, uchar* out) {
  const int share = int(256 * darkness.share), least = darkness.least_contrast_grey;
  for (int x = 0; x < columns; ++x) {
    const int contrast = high[x] - low[x];
    const auto threshold = uchar(low[x] + (share * contrast + 128) / 256);
    out[x] = contrast < least ? uchar(0) : threshold;
  }
}

void compare(const uchar* grey, const uchar* thresholds_of_tiles, int columns, uchar* dark) {
  for (int x = 0; x < columns; ++x) {
    const uchar threshold = thresholds_of_tiles[x];
    dark[2 * x] = grey[2 * x] < threshold;
    dark[2 * x + 1] = grey[2 * x + 1] < threshold;
  }
}

// Neighbours clockwise from the right, y down.
constexpr std::array<int, 8> kStepX = {1, 1, 0, -1, -1, -1, 0, 1}, kStepY = {0, 1, 1, 1, 0, -1, -1, -1};
constexpr int kLeft = 4;
constexpr uchar kDark = 1, kFollowed = 2;

/// Follows one border from a dark pixel whose left neighbour is light, and marks it.
class BorderWalk {
 public:
  explicit BorderWalk(cv::Mat& areas) : areas_(areas) {
    for (int i = 0; i < 8; ++i) offsets_[i] = kStepY[i] * std::ptrdiff_t(areas.step[0]) + kStepX[i];
  }

  /// Returns twice the enclosed area, < 0 for the border of a hole.
  long follow(cv::Point start, Outline& border) const {
    border.clear();
    uchar* at = areas_.ptr<uchar>(start.y) + start.x;
    uchar* const first = at;
    cv::Point p = start;
    const int first_step = nextStep(at, kLeft);
    *at = kFollowed;
    long area2 = 0;
    if (first_step < 0) {
      border.push_back(p);
      return 0;
    }
    for (int step = first_step;;) {
      border.push_back(p);
      const cv::Point next(p.x + kStepX[step], p.y + kStepY[step]);
      area2 += long(p.x) * next.y - long(next.x) * p.y;
      p = next, at += offsets_[step];
      *at = kFollowed;
      // Begins with the light pixel examined last, as seen from the new position.
      step = nextStep(at, (step + (step % 2 == 0 ? 6 : 5)) % 8);
      if (at == first && step == first_step) return area2;
    }
  }

 private:
  /// The first direction after `from`, clockwise, that leads to a dark pixel; -1: none.
  int nextStep(const uchar* at, int from) const {
    for (int i = 1; i <= 8; ++i) {
      const int step = (from + i) % 8;
      if (at[offsets_[step]] != 0) return step;
    }
    return -1;
  }

  cv::Mat& areas_;
  std::array<std::ptrdiff_t, 8> offsets_{};
};

/// The first place from `x` on that is `value`, or `columns`.
int find(const uchar* row, int x, int columns, uchar value) {
  const void* place = std::memchr(row + x, value, std::size_t(columns - x));
  return place == nullptr ? columns : int(static_cast<const uchar*>(place) - row);
}

/// The next dark pixel from the light pixel `x` on that is not followed yet and comes after a light one;
/// `columns`: none.
int nextStart(const uchar* row, int x, int columns) {
  for (;;) {
    x = find(row, x, columns, kDark);
    if (x == columns || row[x - 1] == 0) return x;
    x = find(row, x, columns, 0);
    if (x == columns) return x;
  }
}

}  // namespace

cv::Mat darkAreas(const cv::Mat& grey, const Darkness& darkness) {
  const TileRange tiles = tilesOf(grey);
  const int rows = tiles.low.rows, columns = tiles.low.cols;
  cv::Mat areas(kTile_px * rows + 2, kTile_px * columns + 2, CV_8U);
  areas.row(0).setTo(0), areas.row(areas.rows - 1).setTo(0);
  std::vector<uchar> between(std::size_t(columns) + 2), low(columns), high(columns), threshold(columns);
  for (int row = 0; row < rows; ++row) {
    const int above = std::max(0, row - 1), below = std::min(rows - 1, row + 1);
    const auto three = [&](const cv::Mat& of) {
      return std::array<const uchar*, 3>{of.ptr<uchar>(above), of.ptr<uchar>(row), of.ptr<uchar>(below)};
    };
    overNeighbours(three(tiles.low), columns, between.data(), low.data(), lower);
    overNeighbours(three(tiles.high), columns, between.data(), high.data(), higher);
    thresholds(low.data(), high.data(), columns, darkness, threshold.data());
    for (int y = kTile_px * row; y < kTile_px * (row + 1); ++y) {
      uchar* out = areas.ptr<uchar>(y + 1);
      compare(grey.ptr<uchar>(y), threshold.data(), columns, out + 1);
      out[0] = out[areas.cols - 1] = 0;
    }
  }
  return areas;
}

Outlines outlinesOf(cv::Mat areas, std::size_t least_points) {
  Outlines outlines;
  const BorderWalk walk(areas);
  Outline border;
  for (int y = 1; y + 1 < areas.rows; ++y) {
    const uchar* row = areas.ptr<uchar>(y);
    for (int x = nextStart(row, 0, areas.cols); x < areas.cols; x = nextStart(row, x, areas.cols)) {
      const long area2 = walk.follow({x, y}, border);
      outlines.points += int(border.size());
      if (area2 <= 0 || border.size() < least_points) continue;
      for (cv::Point& p : border) p -= cv::Point(1, 1);  // removes the added rim
      outlines.areas.push_back(border);
    }
  }
  return outlines;
}

}  // namespace facenav::coil_tracking
