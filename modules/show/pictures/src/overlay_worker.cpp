#include "facenav/pictures/overlay_worker.h"

#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/latest_value.h"
#include "facenav/core/log.h"
#include "facenav/session/session.h"

namespace facenav::pictures {
namespace {

CameraOverlay drawOrder(const OverlayOrder& order) {
  return drawOverlay(order.rig, *order.state, order.target, order.alignment);
}

}  // namespace

bool isTooOld(const DrawnOverlay& drawn, const session::NavigationState& now) {
  static const double kMostBehind_s = session::SessionOptions().age_limit_s;  // same limit as for poses
  return now.arrived - drawn.state->arrived > kMostBehind_s;
}

bool mayBeShown(const DrawnOverlay& drawn, const session::NavigationState& now) {
  const session::NavigationState& then = *drawn.state;
  const bool says_the_same = bool(then.camera_T_mri) == bool(now.camera_T_mri) &&
                             bool(then.camera_T_coil) == bool(now.camera_T_coil) &&
                             then.target == now.target && then.failure == now.failure &&
                             session::lossTitles(then) == session::lossTitles(now);
  return now.arrived - then.arrived >= 0 && !isTooOld(drawn, now) && says_the_same;
}

struct OverlayWorker::Implementation {
  Deliver deliver;
  Draw draw;
  LatestValue<OverlayOrder> orders;
  std::thread thread;

  std::shared_ptr<DrawnOverlay> drawn(const OverlayOrder& order) const;
  void run();
};

// Catches all failures, because one on this thread must not end the program.
std::shared_ptr<DrawnOverlay> OverlayWorker::Implementation::drawn(const OverlayOrder& order) const {
  auto picture = std::make_shared<DrawnOverlay>();
  picture->state = order.state;
  picture->captured = order.state->captured;
  try {
    picture->overlay = draw(order);
  } catch (const std::exception& error) {
    logWarning(std::string("the camera pictures were not drawn: ") + error.what());
    picture->failure = error.what();
  }
  return picture;
}

void OverlayWorker::Implementation::run() {
  while (!orders.isClosed()) {
    const auto order = orders.take(std::chrono::milliseconds(200));
    if (!order || orders.isClosed()) continue;
    auto picture = drawn(*order);
    if (orders.isClosed()) break;
    try {
      deliver(std::move(picture));
    } catch (const std::exception& error) {
      logWarning(std::string("a camera picture was not shown: ") + error.what());
    }
  }
}

OverlayWorker::OverlayWorker(Deliver deliver, Draw draw)
    : implementation_(std::make_unique<Implementation>()) {
  FACENAV_EXPECT(bool(deliver), "someone must take the pictures");
  implementation_->deliver = std::move(deliver);
  implementation_->draw = draw ? std::move(draw) : Draw(drawOrder);
  implementation_->thread = std::thread([this] { implementation_->run(); });
}

OverlayWorker::~OverlayWorker() {
  implementation_->orders.close();
  implementation_->thread.join();
}

void OverlayWorker::ask(OverlayOrder order) {
  FACENAV_EXPECT(order.state != nullptr, "a state is needed");
  implementation_->orders.publish(std::make_shared<OverlayOrder>(std::move(order)));
}

}  // namespace facenav::pictures
