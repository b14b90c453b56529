#pragma once
// Session: the live loop of ARCHITECTURE.md. Capture thread: FrameSource -> LatestValue<frame> (recorded
// sources are paced by their time stamps). Tracking thread: newest frame -> Navigator ->
// LatestValue<NavigationState>. Old frames are overwritten, never queued, and counted. The consumer calls
// latest() at its own rate. Past the age limit, after a fault or after the recording's end, latest() is
// blanked: an old pose is never shown.

#include <functional>
#include <memory>
#include <optional>

#include "facenav/capture/frame_source.h"
#include "facenav/core/field.h"
#include "facenav/core/latest_value.h"
#include "facenav/session/navigator.h"
#include "facenav/session/recorder.h"

namespace facenav::session {

struct SessionOptions {
  double age_limit_s = 0.25;  // an older state is stale
  bool is_paced = true;       // recordings: deliver frames at their time stamps; false for live cameras
  double speed = 1.0;         // of a paced source, relative to real time

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(Field{"age_limit_s", "a pose older than this is not shown", 0.02, 5.0}, self.age_limit_s);
    visitor(Field{"is_paced", "play a recording by its time stamps"}, self.is_paced);
    visitor(Field{"speed", "playing speed of a recording, 1 = as recorded", 0.05, 20.0}, self.speed);
  }
};

/// Reason why a session ended.
enum class SessionEnd { none, source, fault, stop };  // none: still running; source: no more frames

class Session {
 public:
  /// Builds a session; nothing runs before start(). `recorder` may be null.
  Session(std::unique_ptr<capture::FrameSource> source, std::unique_ptr<Navigator> navigator,
          const SessionOptions& options, std::unique_ptr<Recorder> recorder = nullptr);
  /// Stops and joins.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void start();
  /// Stops both threads after their current frame; returns when they have ended. Safe to call twice.
  void stop();
  /// Newest state, blanked ("stale") when older than the age limit. Never null; stale before the first frame.
  std::shared_ptr<const NavigationState> latest() const;
  /// Waits for a state that was not taken before; null on time-out or at the end. Not blanked.
  std::shared_ptr<const NavigationState> take(std::chrono::milliseconds timeout);
  /// The states as they are published, not blanked, for another thread to wait for. They outlive the session.
  std::shared_ptr<const LatestValue<NavigationState>> states() const;
  /// True once the source has ended and its last frame was tracked, or a fault stopped the session.
  bool hasEnded() const;
  /// Reason why it ended; a later stop does not change it.
  SessionEnd end() const;
  /// Time from start() until the end, or until now, s; 0 before.
  double elapsed_s() const;
  void setTarget(std::optional<ChosenTarget> target);
  /// Calls Navigator::setSecondTarget, from the next frame on.
  void setSecondTarget(std::optional<ChosenTarget> target);
  /// Calls `listener` with every state, from the next frame on, and with that of a failure. It runs on the
  /// tracking thread and must return at once. Empty: none.
  void follow(std::function<void(const NavigationState&)> listener);
  /// Calls Navigator::setCoil, from the next frame on.
  void setCoil(const coil_tracking::CoilModel& coil);
  /// Calls Navigator::checkRegistration, from the next frame on.
  void checkRegistration(bool is_withheld_until = false);
  /// Calls Navigator::judgeAlignment, from the next frame on.
  void judgeAlignment(bool is_wrong);
  const Recorder* recorder() const;
  /// Key frames of the patient's face from this session, to store with the case; only after stop().
  std::vector<casefile::StoredKeyFrame> learntKeyFrames() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
