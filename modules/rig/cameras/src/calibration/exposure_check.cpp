#include "exposure_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/calib3d.hpp>

#include "board_pose.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::cameras {
namespace {

using Corners = std::vector<cv::Point2f> BoardView::*;
using Numbers = std::vector<int> BoardView::*;

constexpr double kWorstByMedian = 2.5;  // a view with this many times the median view's error disagrees
constexpr double kNeverBad_px = 0.15;   // below this no view disagrees, however good the others are

std::size_t worstOf(const std::vector<double>& values) {
  return std::size_t(std::max_element(values.begin(), values.end()) - values.begin());
}

// Calibrates this camera alone from these views and gives each view's rms.
std::vector<double> rmsAlone(const std::vector<BoardView>& views, const ViewIndices& used, Corners corners,
                             Numbers numbers, const cv::Size& size, const Board& board) {
  std::vector<std::vector<cv::Point3f>> points;
  std::vector<std::vector<cv::Point2f>> seen;
  for (const std::size_t i : used) {
    points.push_back(boardPoints(board, views[i].*numbers));
    seen.push_back(views[i].*corners);
  }
  cv::Mat k, distortion, errors;
  const auto skipped = cv::noArray();
  std::vector<cv::Mat> turns, shifts;
  cv::calibrateCamera(points, seen, size, k, distortion, turns, shifts, skipped, skipped, errors,
                      cv::CALIB_FIX_K3);
  return {errors.begin<double>(), errors.end<double>()};
}

struct Alone {
  ViewIndices bad;
  double median_px = 0;
};

// Leaves out the worst view and calibrates again until all agree.
Alone checkAlone(const std::vector<BoardView>& views, Corners corners, Numbers numbers, const cv::Size& size,
                 const Board& board, std::size_t fewest) {
  ViewIndices used(views.size());
  std::iota(used.begin(), used.end(), std::size_t{0});
  Alone alone;
  while (true) {
    const auto rms = rmsAlone(views, used, corners, numbers, size, board);
    alone.median_px = upperMedian(rms);
    const std::size_t worst = worstOf(rms);
    if (used.size() <= fewest || rms[worst] < largestAgreeing_px(alone.median_px)) return alone;
    alone.bad.push_back(used[worst]);
    used.erase(used.begin() + std::ptrdiff_t(worst));
  }
}

std::vector<double> rmsTogether(const std::vector<BoardView>& views, const ViewIndices& of,
                                const StereoRig& rig, const Board& board) {
  std::vector<double> rms;
  for (const std::size_t i : of) rms.push_back(fitBoard(rig, views[i], board).rms_px());
  return rms;
}

}  // namespace

double largestAgreeing_px(double alone_px) { return std::max(kNeverBad_px, kWorstByMedian * alone_px); }

TrustedViews trustedViews(const std::vector<BoardView>& views, const cv::Size& size, const Board& board,
                          std::size_t fewest, const std::function<StereoRig(const ViewIndices&)>& solve) {
  const Alone left = checkAlone(views, &BoardView::left, &BoardView::left_ids, size, board, fewest);
  const Alone right = checkAlone(views, &BoardView::right, &BoardView::right_ids, size, board, fewest);
  TrustedViews trusted;
  trusted.bad_left = left.bad;
  trusted.bad_right = right.bad;
  trusted.alone_px = std::hypot(left.median_px, right.median_px) / std::sqrt(2.0);
  const auto isIn = [](const ViewIndices& list, std::size_t i) {
    return std::find(list.begin(), list.end(), i) != list.end();
  };
  ViewIndices good;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (!isIn(left.bad, i) && !isIn(right.bad, i)) good.push_back(i);
  const double limit_px = largestAgreeing_px(trusted.alone_px);
  trusted.used = good;
  while (trusted.used.size() > fewest) {
    const auto rms = rmsTogether(views, trusted.used, solve(trusted.used), board);
    const std::size_t worst = worstOf(rms);
    if (rms[worst] < limit_px) break;
    trusted.used.erase(trusted.used.begin() + std::ptrdiff_t(worst));
  }
  // Gives views a second chance that were left out only because the views that moved had bent the rig.
  if (trusted.used.size() < good.size()) {
    const auto rms = rmsTogether(views, good, solve(trusted.used), board);
    for (std::size_t i = 0; i < good.size(); ++i)
      if (rms[i] < limit_px && !isIn(trusted.used, good[i])) trusted.used.push_back(good[i]);
    std::sort(trusted.used.begin(), trusted.used.end());
  }
  // The loop stops at `fewest` views, so the worst may still be among them.
  if (trusted.used.size() <= fewest && good.size() > 0) {
    ViewIndices agreeing;
    const auto rms = rmsTogether(views, trusted.used, solve(trusted.used), board);
    for (std::size_t i = 0; i < trusted.used.size(); ++i)
      if (rms[i] < limit_px) agreeing.push_back(trusted.used[i]);
    trusted.used = agreeing;
  }
  for (const std::size_t i : good)
    if (!isIn(trusted.used, i)) trusted.moved.push_back(i);
  return trusted;
}

double movedBetween_mm(const StereoRig& rig, const BoardView& view, const Board& board) {
  const auto points = boardPoints(board);
  const Eigen::Isometry3d left_T_board =
      solveBoardPose(rig.left, boardPoints(board, view.left_ids), view.left);
  const Eigen::Isometry3d by_right =
      rig.right_T_left.isometry().inverse() *
      solveBoardPose(rig.right, boardPoints(board, view.right_ids), view.right);
  double squares_mm2 = 0;
  for (const cv::Point3f& point : points) {
    const Eigen::Vector3d p(point.x, point.y, point.z);
    squares_mm2 += (left_T_board * p - by_right * p).squaredNorm();
  }
  return std::sqrt(squares_mm2 / double(points.size()));
}

}  // namespace facenav::cameras
