#include "facenav/pictures/overlay_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <thread>

namespace facenav::pictures {
namespace {

using Drawn = std::shared_ptr<const DrawnOverlay>;

session::NavigationState state(std::int64_t frame, bool is_tracked = true) {
  session::NavigationState s;
  s.frame = frame;
  s.captured = {frame * 0.02};
  s.arrived = {1000.0 + frame * 0.02};
  s.is_aligned = true;
  if (!is_tracked) return s;
  s.head = {head_tracking::HeadPose{}, 0.9};
  s.coil = {coil_tracking::CoilPose{}, 0.9};
  s.camera_T_mri = {RigidTransform<Camera, Mri>(), 0.9};
  s.camera_T_coil = {RigidTransform<Camera, Coil>(), 0.9};
  return s;
}

OverlayOrder orderOf(std::int64_t frame) {
  return {{}, std::make_shared<session::NavigationState>(state(frame)), {}};
}

DrawnOverlay pictureOf(const session::NavigationState& shown) {
  return {{}, std::make_shared<session::NavigationState>(shown), shown.captured, {}};
}

TEST(OverlayWorker, DrawsOnAThreadOfItsOwnAndSaysWhatItShows) {
  std::promise<Drawn> delivered;
  std::atomic<std::thread::id> drew{};
  OverlayWorker worker([&](Drawn drawn) { delivered.set_value(std::move(drawn)); },
                       [&](const OverlayOrder&) {
                         drew = std::this_thread::get_id();
                         return CameraOverlay{RgbImage(4, 3), RgbImage(4, 3)};
                       });
  const auto order = orderOf(7);
  worker.ask(order);
  const Drawn drawn = delivered.get_future().get();
  EXPECT_NE(drew.load(), std::this_thread::get_id());
  EXPECT_EQ(drawn->state, order.state);
  EXPECT_DOUBLE_EQ(drawn->captured.s, 0.14);
  EXPECT_EQ(drawn->overlay.left.width_px, 4);
}

TEST(OverlayWorker, DrawsTheNewestOrderOnlyAndNeverHoldsUpWhoAsks) {
  std::promise<void> may_draw;
  std::promise<void> has_newest;
  const std::shared_future<void> gate(may_draw.get_future());
  std::atomic<int> drawings{0};
  std::atomic<std::int64_t> last{-1};
  OverlayWorker worker(
      [&](Drawn drawn) {
        last = drawn->state->frame;
        if (last == 99) has_newest.set_value();
      },
      [&](const OverlayOrder&) {
        ++drawings;
        gate.wait();
        return CameraOverlay{};
      });
  for (int i = 0; i < 100; ++i) worker.ask(orderOf(i));  // blocks here if ask() waits
  may_draw.set_value();
  has_newest.get_future().wait();
  EXPECT_EQ(last, 99);
  EXPECT_LE(drawings, 2);  // the one in progress and the newest
}

TEST(OverlayWorker, AFailureIsDeliveredInWordsAndTheNextPictureIsDrawn) {
  std::promise<Drawn> first, second;
  OverlayWorker worker([&](Drawn drawn) { (drawn->state->frame == 1 ? first : second).set_value(drawn); },
                       [](const OverlayOrder& order) -> CameraOverlay {
                         if (order.state->frame == 1) throw std::runtime_error("no such picture");
                         return {RgbImage(2, 2), RgbImage(2, 2)};
                       });
  worker.ask(orderOf(1));
  EXPECT_EQ(first.get_future().get()->failure, "no such picture");
  worker.ask(orderOf(2));
  EXPECT_EQ(second.get_future().get()->failure, "");
}

TEST(OverlayWorker, DeliversNothingAfterItHasGone) {
  std::atomic<bool> is_gone{false}, came_late{false};
  {
    OverlayWorker worker([&](Drawn) { came_late = came_late || is_gone; },
                         [](const OverlayOrder&) {
                           std::this_thread::sleep_for(std::chrono::milliseconds(30));
                           return CameraOverlay{};
                         });
    worker.ask(orderOf(1));
    worker.ask(orderOf(2));
  }
  is_gone = true;
  std::this_thread::sleep_for(std::chrono::milliseconds(80));
  EXPECT_FALSE(came_late);
}

TEST(MayBeShown, APictureOfTheNewestStateOrOneJustBefore) {
  EXPECT_TRUE(mayBeShown(pictureOf(state(10)), state(10)));
  EXPECT_TRUE(mayBeShown(pictureOf(state(10)), state(22)));   // 0.24 s behind
  EXPECT_FALSE(mayBeShown(pictureOf(state(10)), state(23)));  // 0.26 s behind: too old for any pose
  EXPECT_FALSE(mayBeShown(pictureOf(state(11)), state(10)));  // from another run of the recording
}

TEST(MayBeShown, NeverAPoseThatIsLostByNow) {
  const auto tracked = state(10);
  EXPECT_FALSE(mayBeShown(pictureOf(tracked), session::blanked(tracked, LostReason::stale)));
  EXPECT_FALSE(mayBeShown(pictureOf(tracked), state(11, false)));
  EXPECT_FALSE(mayBeShown(pictureOf(state(10, false)), state(11)));
  auto other_target = state(11);
  other_target.target = "other";
  EXPECT_FALSE(mayBeShown(pictureOf(tracked), other_target));
}

}  // namespace
}  // namespace facenav::pictures
