#include "facenav/cameras/board_quality.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::cameras {
namespace {

constexpr int kSamples = 41;  // samples of a profile across an edge

/// Corners by their numbers; nullopt for corners that were not seen.
std::vector<std::optional<cv::Point2f>> byNumber(const SeenCorners& seen, const Board& board) {
  std::vector<std::optional<cv::Point2f>> all(std::size_t(board.corners()));
  for (std::size_t i = 0; i < seen.px.size(); ++i) all[std::size_t(seen.ids[i])] = seen.px[i];
  return all;
}

std::vector<float> profile(const cv::Mat& image, cv::Point2f from, cv::Point2f to) {
  cv::Mat x(1, kSamples, CV_32F), y(1, kSamples, CV_32F), grey;
  for (int i = 0; i < kSamples; ++i) {
    const cv::Point2f at = from + (to - from) * (float(i) / (kSamples - 1));
    x.at<float>(i) = at.x;
    y.at<float>(i) = at.y;
  }
  cv::remap(image, grey, x, y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  std::vector<float> values(kSamples);
  for (int i = 0; i < kSamples; ++i) values[std::size_t(i)] = float(grey.at<std::uint8_t>(i));
  return values;
}

/// Position, in samples, where a rising profile passes `level`, searched from its middle outwards.
std::optional<double> crossing(const std::vector<float>& values, double level, int step) {
  for (int i = kSamples / 2; i > 0 && i < kSamples - 1; i += step) {
    const double here = values[std::size_t(i)], next = values[std::size_t(i + step)];
    if ((here - level) * (next - level) <= 0 && here != next)
      return i + step * (level - here) / (next - here);
  }
  return std::nullopt;
}

struct QualitySamples {
  std::vector<double> widths_px, whites, blacks, squares_px;
};

/// Adds one edge, crossed in its middle at a right angle, `span` squares to either side.
void addEdge(const cv::Mat& image, cv::Point2f a, cv::Point2f b, float span, QualitySamples& samples) {
  const cv::Point2f edge = b - a, across(-edge.y * span, edge.x * span), middle = 0.5F * (a + b);
  auto values = profile(image, middle - across, middle + across);
  samples.squares_px.push_back(cv::norm(edge));
  if (values.front() > values.back()) std::reverse(values.begin(), values.end());
  const double black = values[4], white = values[kSamples - 5];
  samples.blacks.push_back(black);
  samples.whites.push_back(white);
  const auto low = crossing(values, black + 0.2 * (white - black), -1),
             high = crossing(values, black + 0.8 * (white - black), 1);
  if (white - black > 10 && low && high)
    samples.widths_px.push_back((*high - *low) * 2 * double(span) * cv::norm(edge) / (kSamples - 1));
}

}  // namespace

BoardQuality boardQuality(const cv::Mat& image, const SeenCorners& seen, const Board& board) {
  FACENAV_EXPECT(image.type() == CV_8U, "8-bit grey expected");
  const auto corners = byNumber(seen, board);
  // The markers of a ChArUco board must not lie in the profile.
  const float span = board.isCharuco() ? float(0.45 * (1 - *board.marker_mm / board.square_mm)) : 0.5F;
  QualitySamples samples;
  for (int r = 0; r < board.rows; ++r)
    for (int c = 0; c < board.columns; ++c) {
      const auto& here = corners[std::size_t(r * board.columns + c)];
      if (!here) continue;
      if (c + 1 < board.columns && corners[std::size_t(r * board.columns + c + 1)])
        addEdge(image, *here, *corners[std::size_t(r * board.columns + c + 1)], span, samples);
      if (r + 1 < board.rows && corners[std::size_t((r + 1) * board.columns + c)])
        addEdge(image, *here, *corners[std::size_t((r + 1) * board.columns + c)], span, samples);
    }
  BoardQuality quality;
  if (samples.whites.empty()) return quality;
  quality.white_grey = median(samples.whites);
  quality.black_grey = median(samples.blacks);
  quality.square_px = median(samples.squares_px);
  if (!samples.widths_px.empty()) quality.edge_px = median(samples.widths_px);
  return quality;
}

}  // namespace facenav::cameras
