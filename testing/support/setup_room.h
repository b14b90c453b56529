#pragma once
// Pictures of two cameras during the set-up, chosen by the test: an empty room, a held board that moves from
// place to place, a board in a new place, the coil's marker. The program must compile
// unit/track/coil_tracking/coil_scene.cpp.

#include <atomic>
#include <map>
#include <thread>

#include "facenav/face/face_landmarks.h"
#include "facenav/setup/rig_setup.h"
#include "support/board_film.h"

namespace facenav::testing {

/// Content of the room. new_place, moved_marker: in one place for a while, then in another. one_place: a
/// board that stays. other_marker: of another coil, id 3. waved_marker: waved before cameras with a rolling
/// shutter.
enum class RoomShows {
  nothing,
  held_board,
  new_place,
  one_place,
  marker,
  moved_marker,
  other_marker,
  waved_marker
};

constexpr double kWaveFrame_s = 1.0 / 30;
constexpr double kWaveRow_s = 42e-6;  // 20 ms a picture of 480 rows

/// Coil's print, waved to and fro as a hand does, at up to 250 mm/s.
inline coil_tracking::testing::PlacedPrint wavedPrint(double t_s) {
  const Eigen::Vector3d reach_mm(30, 22, 25), turn_rad_s(2 * M_PI * 1.2, 2 * M_PI * 0.9, 2 * M_PI * 0.7);
  auto pose = coil_tracking::testing::markerPose(600, 20, 70, 10, {-40, 60}).isometry();
  coil_tracking::testing::PlacedPrint print{coil_tracking::testing::arucoPrint(0, 7), 60, {}};
  for (int axis = 0; axis < 3; ++axis) {
    pose.translation()[axis] += reach_mm[axis] * std::sin(turn_rad_s[axis] * t_s);
    print.moving_mm_s[axis] = reach_mm[axis] * turn_rad_s[axis] * std::cos(turn_rad_s[axis] * t_s);
  }
  print.camera_T_marker = RigidTransform<Camera, Marker>::fromIsometry(pose);
  return print;
}

/// Frame `i` of the waved print; cameras of `rig` with kWaveRow_s.
inline cameras::StereoFrame wavedFrame(cameras::StereoRig rig, int i) {
  rig.left.row_time_s = rig.right.row_time_s = kWaveRow_s;
  coil_tracking::testing::SceneOptions options;
  options.seed = unsigned(i + 1);
  auto frame = coil_tracking::testing::renderMarkers(rig, {wavedPrint(i * kWaveFrame_s)}, options);
  frame.number = i;
  frame.captured.s = i * kWaveFrame_s;
  return frame;
}

/// State shared by the test and the source.
struct SetupRoom {
  std::atomic<RoomShows> shows{RoomShows::nothing};
  std::atomic<double> turned_deg{0};  // sideways rotation of the right camera on its mount
  std::atomic<bool> is_unplugged{false};
};

class SetupRoomSource : public capture::FrameSource {
 public:
  SetupRoomSource(std::shared_ptr<SetupRoom> room, const cameras::StereoRig& rig)
      : room_(std::move(room)), rig_(rig), places_(boardRound()) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (room_->is_unplugged) throw Error("the camera was unplugged", "Webcam", "plug it in");
    auto frame = std::make_shared<cameras::StereoFrame>(picture());
    frame->number = number_;
    ++number_;
    frame->captured = {now_s_ += room_->shows == RoomShows::waved_marker ? kWaveFrame_s : 0.15};
    return frame;
  }

 private:
  cameras::StereoFrame picture() {
    const RoomShows shows = room_->shows;
    if (shows == RoomShows::waved_marker) return wavedFrame(rig_, waved_++);
    const bool has_two = shows == RoomShows::new_place || shows == RoomShows::moved_marker;
    const int place = shows == RoomShows::held_board ? int(held_++ / 4) % int(places_.size())
                      : has_two                      ? int(moved_++ / 30) % 2
                                                     : 0;
    const auto key = std::tuple(shows, place, room_->turned_deg.load());
    auto known = pictures_.find(key);
    if (known == pictures_.end()) known = pictures_.emplace(key, rendered(shows, place)).first;
    return known->second;
  }
  cameras::StereoFrame rendered(RoomShows shows, int place) const {
    const auto real = turnedRight(rig_, {0, room_->turned_deg * kRadPerDeg, 0});
    if (shows == RoomShows::held_board) return heldBoardFrame(real, places_[std::size_t(place)], place, 0);
    if (shows == RoomShows::new_place || shows == RoomShows::one_place)
      return heldBoardFrame(
          real, place == 0 ? HeldBoard{640, 18, 70, 12, {25, -15}} : HeldBoard{540, 22, 200, 12, {-20, 10}},
          77, 0);
    coil_tracking::testing::SceneOptions options;
    std::vector<coil_tracking::testing::PlacedPrint> prints;
    if (shows != RoomShows::nothing)
      prints.push_back({coil_tracking::testing::arucoPrint(0, shows == RoomShows::other_marker ? 3 : 7), 60.0,
                        coil_tracking::testing::markerPose(place == 0 ? 580 : 460, 20, 40, 10)});
    return coil_tracking::testing::renderMarkers(real, prints, options);
  }

  std::shared_ptr<SetupRoom> room_;
  cameras::StereoRig rig_;
  std::vector<HeldBoard> places_;
  std::map<std::tuple<RoomShows, int, double>, cameras::StereoFrame> pictures_;
  std::int64_t number_ = 0, held_ = 0, moved_ = 0;
  int waved_ = 0;
  double now_s_ = -0.15;
};

/// Detects the face `face` in every picture.
class FixedFace : public face::FaceDetector {
 public:
  explicit FixedFace(std::optional<cv::Rect> face) : face_(face) {}
  std::optional<face::FaceLandmarks> detect(const cv::Mat&) const override { return found(); }
  std::optional<face::FaceLandmarks> detectNear(const cv::Mat&, const face::FaceLandmarks&) const override {
    return found();
  }
  std::optional<face::FaceLandmarks> detectAtRoll(const cv::Mat&, double) const override { return found(); }

 private:
  std::optional<face::FaceLandmarks> found() const {
    if (!face_) return std::nullopt;
    face::FaceLandmarks landmarks;
    landmarks.face = *face_;
    return landmarks;
  }
  std::optional<cv::Rect> face_;
};

inline steps::SetupMethods setupMethods() {
  return {std::make_shared<FixedFace>(cv::Rect(220, 130, 200, 200)),
          [] { return coil_tracking::makeMarkerCoilTracker(); }};
}

/// Waits until `condition` is true for the newest view; false if the limit passes first.
inline bool waitForView(const steps::RigSetup& setup,
                        const std::function<bool(const steps::SetupView&)>& condition, double limit_s = 120) {
  const double until_s = Timestamp::now().s + limit_s;
  while (Timestamp::now().s < until_s) {
    if (condition(*setup.latest())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace facenav::testing
