#pragma once
// A person who shows the calibration board to a rig: moves it, holds it still, moves it on. Rendered pairs
// with noise. The program must compile unit/track/coil_tracking/coil_scene.cpp.

#include <map>

#include "facenav/capture/frame_source.h"
#include "support/board_scene.h"

namespace facenav::testing {

struct HeldBoard {
  double distance_mm = 600, tilt_deg = 20, axis_deg = 0, turn_deg = 0;
  Eigen::Vector2d side_mm{0, 0};
};

/// Sixteen places that cover the pictures, both distances and four tilts.
inline std::vector<HeldBoard> boardRound() {
  std::vector<HeldBoard> all;
  for (const auto& [x, y] : {std::pair(0, 0), {-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {0, -1}, {0, 1}, {-1, 0}})
    for (const int pass : {0, 1}) {
      HeldBoard held;
      held.distance_mm = pass == 0 ? 560 : 760;
      held.side_mm = {(pass == 0 ? 60.0 : 100.0) * x, (pass == 0 ? 42.0 : 75.0) * y};
      held.axis_deg = 45.0 * double(all.size()) + 10;
      held.tilt_deg = 28;
      all.push_back(held);
    }
  return all;
}

/// Frame of the held board; rendered once, since it takes a tenth of a second.
inline cameras::StereoFrame heldBoardFrame(const cameras::StereoRig& rig, const HeldBoard& held,
                                           std::int64_t number, double t_s,
                                           coil_tracking::testing::SceneOptions options = {}) {
  static std::map<std::vector<double>, cameras::StereoFrame> rendered;
  const Eigen::Quaterniond turn(rig.right_T_left.rotation());
  const std::vector<double> key = {held.distance_mm,   held.tilt_deg,      held.axis_deg,
                                   held.turn_deg,      held.side_mm.x(),   held.side_mm.y(),
                                   turn.x(),           turn.y(),           turn.z(),
                                   options.white_grey, options.black_grey, options.blur_sigma_px};
  const auto pose = coil_tracking::testing::markerPose(held.distance_mm, held.tilt_deg, held.axis_deg,
                                                       held.turn_deg, held.side_mm);
  options.has_clutter = false;
  auto known = rendered.find(key);
  if (known == rendered.end()) {
    options.seed = unsigned(rendered.size() + 1);
    known =
        rendered.emplace(key, coil_tracking::testing::renderMarkers(rig, {placedBoard(pose)}, options)).first;
  }
  cameras::StereoFrame frame = known->second;
  frame.number = number;
  frame.captured = {t_s};
  return frame;
}

/// Film of the board: it moves between two places and rests at each for `still_frames`.
class BoardFilm : public capture::FrameSource {
 public:
  BoardFilm(const cameras::StereoRig& rig, std::vector<HeldBoard> places, int still_frames = 4,
            double interval_s = 0.15)
      : rig_(rig), places_(std::move(places)), still_frames_(still_frames), interval_s_(interval_s) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    const std::size_t place = std::size_t(number_ / (still_frames_ + 1));
    if (place >= places_.size()) return nullptr;
    auto frame = heldBoardFrame(rig_, places_[place], number_, interval_s_ * double(number_));
    if (number_ % (still_frames_ + 1) == 0)  // between two places
      for (cv::Mat* image : {&frame.left, &frame.right}) *image = shifted(*image, 12);
    ++number_;
    return std::make_shared<cameras::StereoFrame>(frame);
  }

 private:
  static cv::Mat shifted(const cv::Mat& image, int by_px) {
    cv::Mat moved(image.size(), CV_8U, cv::Scalar(90));
    const int width = image.cols - by_px;
    image.colRange(0, width).copyTo(moved.colRange(by_px, image.cols));
    return moved;
  }
  cameras::StereoRig rig_;
  std::vector<HeldBoard> places_;
  int still_frames_;
  double interval_s_;
  std::int64_t number_ = 0;
};

}  // namespace facenav::testing
