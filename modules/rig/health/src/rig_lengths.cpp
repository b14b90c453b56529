#include "facenav/health/rig_lengths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>

namespace facenav::health {
namespace {

constexpr std::size_t kFewestCorners = 8;
constexpr double kCorner_px = 0.1;  // standard error of a corner in one picture
constexpr double kLongShare = 0.6;  // share of the longest distance: shorter ones measure the corners' noise

Eigen::Vector2d eigenOf(const cv::Point2f& p) { return {p.x, p.y}; }

std::vector<Eigen::Vector3d> inSpace(const BoardPair& pair, const cameras::StereoRig& rig) {
  std::vector<Eigen::Vector3d> points_mm;
  for (std::size_t i = 0; i < pair.ids.size(); ++i)
    points_mm.push_back(cameras::triangulate(rig, eigenOf(pair.left_px[i]), eigenOf(pair.right_px[i])).mm);
  return points_mm;
}

}  // namespace

std::optional<BoardPair> findBoardPair(const cv::Mat& left, const cv::Mat& right,
                                       const cameras::Board& board) {
  const cameras::SeenCorners in_left = cameras::findBoard(left, board);
  if (in_left.ids.size() < kFewestCorners) return std::nullopt;
  const cameras::SeenCorners in_right = cameras::findBoard(right, board);
  std::map<int, cv::Point2f> by_id;
  for (std::size_t i = 0; i < in_right.ids.size(); ++i) by_id[in_right.ids[i]] = in_right.px[i];
  BoardPair pair;
  for (std::size_t i = 0; i < in_left.ids.size(); ++i) {
    const auto other = by_id.find(in_left.ids[i]);
    if (other == by_id.end()) continue;
    pair.ids.push_back(in_left.ids[i]);
    pair.left_px.push_back(in_left.px[i]);
    pair.right_px.push_back(other->second);
  }
  if (pair.ids.size() < kFewestCorners) return std::nullopt;
  pair.board_mm = cameras::boardPoints(board, pair.ids);
  return pair;
}

std::vector<Correspondence> correspondences(const BoardPair& pair) {
  std::vector<Correspondence> points;
  for (std::size_t i = 0; i < pair.ids.size(); ++i)
    points.push_back({eigenOf(pair.left_px[i]), eigenOf(pair.right_px[i]), std::sqrt(2.0) * kCorner_px});
  return points;
}

std::optional<SquareObservation> squareOf(const BoardPair& pair, const cameras::Board& board,
                                          const cameras::StereoRig& rig) {
  std::map<int, std::size_t> at;
  for (std::size_t i = 0; i < pair.ids.size(); ++i) at[pair.ids[i]] = i;
  for (int side = std::min(board.columns, board.rows) - 1; side > 0; --side)
    for (int row = 0; row + side < board.rows; ++row)
      for (int column = 0; column + side < board.columns; ++column) {
        const int first = row * board.columns + column, below = first + side * board.columns;
        const std::array<int, 4> ids = {first, first + side, below + side, below};
        if (!std::all_of(ids.begin(), ids.end(), [&](int id) { return at.count(id) > 0; })) continue;
        SquareObservation square;
        for (std::size_t i = 0; i < 4; ++i) {
          square.left_px[i] = eigenOf(pair.left_px[at[ids[i]]]);
          square.right_px[i] = eigenOf(pair.right_px[at[ids[i]]]);
        }
        square.sigma_px = std::sqrt(2.0) * kCorner_px;
        square.size_mm = side * board.square_mm;
        square.print_sigma_mm = kBoardPrint * square.size_mm;
        const double distance_mm = cameras::triangulate(rig, square.left_px[0], square.right_px[0]).mm.norm();
        square.size_sigma_mm = kCorner_px * distance_mm / rig.left.k(0, 0);
        return square;
      }
  return std::nullopt;
}

BoardPair exchanged(BoardPair pair) {
  std::swap(pair.left_px, pair.right_px);
  return pair;
}

SquareObservation exchanged(SquareObservation marker) {
  std::swap(marker.left_px, marker.right_px);
  return marker;
}

double scaleChange(const SingleView& left, const SingleView& right, const cameras::StereoRig& rig) {
  const Eigen::Vector3d board_mm = left.camera_T_board.translation();
  const double predicted_mm = (rig.right_T_left.isometry() * board_mm).norm();
  return predicted_mm / right.camera_T_board.translation().norm() - 1.0;
}

double lengthRatio(const BoardPair& pair, const cameras::StereoRig& rig) {
  const auto points_mm = inSpace(pair, rig);
  double longest_mm = 0, measured_mm = 0, true_mm = 0;
  const auto trueLength = [&](std::size_t i, std::size_t j) {
    return cv::norm(pair.board_mm[i] - pair.board_mm[j]);
  };
  for (std::size_t i = 1; i < points_mm.size(); ++i) longest_mm = std::max(longest_mm, trueLength(0, i));
  for (std::size_t i = 0; i < points_mm.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (trueLength(i, j) < kLongShare * longest_mm) continue;
      true_mm += trueLength(i, j);
      measured_mm += (points_mm[i] - points_mm[j]).norm();
    }
  return true_mm > 0 ? measured_mm / true_mm : std::nan("");
}

double lengthRatio(const SquareObservation& marker, const cameras::StereoRig& rig) {
  double side_mm = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    side_mm += (cameras::triangulate(rig, marker.left_px[i], marker.right_px[i]).mm -
                cameras::triangulate(rig, marker.left_px[next], marker.right_px[next]).mm)
                   .norm() /
               4;
  }
  return side_mm / marker.size_mm;
}

SingleView fitBoard(const cameras::CameraModel& camera, const std::vector<cv::Point2f>& px,
                    const std::vector<cv::Point3f>& board_mm) {
  cv::Vec3d turn, shift;
  cv::solvePnP(board_mm, px, camera.k, camera.distortion, turn, shift);
  std::vector<cv::Point2f> fitted;
  cv::projectPoints(board_mm, turn, shift, camera.k, camera.distortion, fitted);
  double squares = 0;
  for (std::size_t i = 0; i < px.size(); ++i) squares += std::pow(cv::norm(px[i] - fitted[i]), 2);
  SingleView view;
  view.rms_px = std::sqrt(squares / double(px.size()));
  const Eigen::Vector3d axis(turn[0], turn[1], turn[2]);
  if (axis.norm() > 0) view.camera_T_board.rotate(Eigen::AngleAxisd(axis.norm(), axis.normalized()));
  view.camera_T_board.pretranslate(Eigen::Vector3d(shift[0], shift[1], shift[2]));
  return view;
}

}  // namespace facenav::health
