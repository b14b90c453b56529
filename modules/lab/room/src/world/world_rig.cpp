// The cameras of a World as they stand, and as a calibration finds them.

#include <cmath>

#include "facenav/cameras/calibrate.h"
#include "facenav/geometry/rotation.h"
#include "facenav/room/world_room.h"
#include "script/dice.h"

namespace facenav::room {
namespace {

double normal(Dice& dice) {
  return std::sqrt(-2.0 * std::log(1.0 - dice.between(0.0, 1.0))) * std::cos(dice.between(0.0, 2.0 * M_PI));
}

/// Corners of the board in one camera; empty unless all are inside the board's share of the picture.
std::vector<cv::Point2f> seenBy(const cameras::CameraModel& camera, const cameras::StereoRig& rig,
                                const Eigen::Isometry3d& camera_T_board,
                                const std::vector<cv::Point3f>& board, double share) {
  std::vector<cv::Point2f> px;
  for (const auto& corner : board) {
    const Eigen::Vector3d p_mm = camera_T_board * Eigen::Vector3d(corner.x, corner.y, corner.z);
    if (p_mm.z() < 50.0) return {};
    const Eigen::Vector2d p = cameras::project(camera, p_mm);
    if (std::abs(2.0 * p.x() / rig.width_px - 1.0) > share ||
        std::abs(2.0 * p.y() / rig.height_px - 1.0) > share)
      return {};
    px.emplace_back(float(p.x()), float(p.y()));
  }
  return px;
}

void blur(Dice& dice, double sigma_px, std::vector<cv::Point2f>& px) {
  for (auto& p : px) p += cv::Point2f(float(sigma_px * normal(dice)), float(sigma_px * normal(dice)));
}

}  // namespace

cameras::StereoRig trueRig(const World& world) { return makeRig(world.cameras.rig); }

cameras::StereoRig calibratedRig(const World& world, const cameras::StereoRig& truth) {
  const WorldCameras& drawn = world.cameras;
  cameras::Board board;
  // A board of two fifths of the narrower view at the head's distance.
  const double view_mm =
      drawn.distance_mm / drawn.rig.focal_px * std::min(drawn.rig.width_px, drawn.rig.height_px);
  board.square_mm = 0.4 * view_mm / (board.columns - 1);
  const auto corners = cameras::boardPoints(board);
  const auto camera_T_room = cameraFromRoom(truth, drawn.rig.roll_deg).isometry();
  const Eigen::Vector3d middle_mm(corners.back().x * 0.5, corners.back().y * 0.5, 0.0);
  Dice dice(world.seed * 977 + 31);
  std::vector<cameras::BoardView> views;
  for (int tried = 0; tried < 20000 && int(views.size()) < drawn.board_views; ++tried) {
    // Where both cameras see little in common, the board comes nearer to the borders.
    const double share = tried < 5000 ? drawn.board_share : 0.98;
    const double depth_mm = drawn.distance_mm * dice.between(0.75, 1.3);
    const double half_mm = 0.5 * depth_mm / drawn.rig.focal_px;
    Eigen::Isometry3d room_T_board = Eigen::Isometry3d::Identity();
    room_T_board.linear() = expRotation(dice.between(0.05, 0.7) * dice.direction());
    room_T_board.translation() =
        Eigen::Vector3d(dice.between(-1.0, 1.0) * half_mm * drawn.rig.width_px,
                        dice.between(-1.0, 1.0) * half_mm * drawn.rig.height_px, depth_mm) -
        room_T_board.linear() * middle_mm;
    const Eigen::Isometry3d camera_T_board = camera_T_room * room_T_board;
    cameras::BoardView view;
    view.left = seenBy(truth.left, truth, camera_T_board, corners, share);
    view.right = seenBy(truth.right, truth, truth.right_T_left.isometry() * camera_T_board, corners, share);
    if (view.left.empty() || view.right.empty()) continue;
    blur(dice, drawn.corner_px, view.left);
    blur(dice, drawn.corner_px, view.right);
    view.name = "view " + std::to_string(views.size() + 1);
    views.push_back(std::move(view));
  }
  TaskMonitor silent;
  return cameras::calibrateCorners(views, {truth.width_px, truth.height_px}, board, silent).rig;
}

}  // namespace facenav::room
