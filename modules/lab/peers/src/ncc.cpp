#include "ncc.h"

#include <Eigen/LU>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace facenav::peers {
namespace {

// Offset of the extremum of the least-squares paraboloid through 3 x 3 scores, each part within +-1.
std::optional<Eigen::Vector2d> paraboloidPeak(const cv::Mat1f& s, int x, int y) {
  const auto at = [&](int dx, int dy) { return double(s(y + dy, x + dx)); };
  double gx = 0, gy = 0, xx = 0, yy = 0;
  for (int d = -1; d <= 1; ++d) {
    gx += (at(1, d) - at(-1, d)) / 6;
    gy += (at(d, 1) - at(d, -1)) / 6;
    xx += (at(1, d) - 2 * at(0, d) + at(-1, d)) / 3;
    yy += (at(d, 1) - 2 * at(d, 0) + at(d, -1)) / 3;
  }
  const double xy = (at(1, 1) - at(-1, 1) - at(1, -1) + at(-1, -1)) / 4;
  Eigen::Matrix2d curvature;
  curvature << xx, xy, xy, yy;
  if (curvature.determinant() <= 0 || xx >= 0) return std::nullopt;
  const Eigen::Vector2d offset = -curvature.inverse() * Eigen::Vector2d(gx, gy);
  if (offset.cwiseAbs().maxCoeff() > 1.0) return std::nullopt;
  return offset;
}

}  // namespace

double ncc(const cv::Mat& image, const cv::Mat& templ) {
  cv::Mat1f score;
  cv::matchTemplate(image, templ, score, cv::TM_CCOEFF_NORMED);
  return std::isfinite(score(0, 0)) && std::abs(score(0, 0)) <= 1.0001 ? score(0, 0) : 0.0;
}

std::optional<NccPeak> findPeak(const cv::Mat& image, const cv::Mat& templ, const Eigen::Vector2d& guess_px,
                                int radius_px) {
  if (!guess_px.allFinite() || guess_px.cwiseAbs().maxCoeff() > 1e5) return std::nullopt;
  const int half_x = templ.cols / 2, half_y = templ.rows / 2;
  const int x = int(std::lround(guess_px.x())), y = int(std::lround(guess_px.y()));
  const cv::Rect window = cv::Rect(x - radius_px - half_x, y - radius_px - half_y, 2 * radius_px + templ.cols,
                                   2 * radius_px + templ.rows) &
                          cv::Rect(0, 0, image.cols, image.rows);
  if (window.width < templ.cols + 2 || window.height < templ.rows + 2) return std::nullopt;
  cv::Mat1f scores;
  cv::matchTemplate(image(window), templ, scores, cv::TM_CCOEFF_NORMED);
  double best = 0;
  cv::Point at;
  cv::minMaxLoc(scores, nullptr, &best, nullptr, &at);
  if (!std::isfinite(best) || best > 1.0001) return std::nullopt;
  if (at.x < 1 || at.y < 1 || at.x >= scores.cols - 1 || at.y >= scores.rows - 1) return std::nullopt;
  const auto offset = paraboloidPeak(scores, at.x, at.y);
  if (!offset) return std::nullopt;
  return NccPeak{Eigen::Vector2d(window.x + at.x + half_x, window.y + at.y + half_y) + *offset, best};
}

}  // namespace facenav::peers
