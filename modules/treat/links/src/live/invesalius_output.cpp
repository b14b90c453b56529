#include "invesalius_output.h"

#include <utility>

#include "facenav/core/log.h"

namespace facenav::links {
namespace {

constexpr const char *kOurEvent = "from_neuronavigation", *kTheirEvent = "to_neuronavigation";
constexpr double kLeastBetween_s = 0.035;  // 25 frames a second of 50 or 60: robots read no faster
constexpr int kMostLines = 5;              // a second, in the log
constexpr double kSameTarget = 1e-3;       // mm, and in the rotation
constexpr int kLeave_ms = 200;

}  // namespace

InvesaliusOutput::InvesaliusOutput(const std::string& name, const RelayPlace& place)
    : ThreadedOutput(name), place_(place), relay_(place.host, place.port, name) {
  tell();
  start();
}

InvesaliusOutput::~InvesaliusOutput() { stop(); }

void InvesaliusOutput::work() {
  std::vector<pollfd> waiting{relay_.wanted()};
  waitFor(waiting);
  relay_.work(waiting[0].revents);
  hear();
  takePulses();  // the relay has no message for them
  if (const auto frame = takeFrame()) send(*frame);
  tell();
}

void InvesaliusOutput::put(const RelayMessage& message) { relay_.send(kOurEvent, bodyOf(message)); }

/// Keeps what a robot says, and greets a relay that has been joined.
void InvesaliusOutput::hear() {
  if (relay_.joins() > greeted_ && relay_.isFree()) {
    greeted_ = relay_.joins();
    sent_target_.reset();  // the programs behind it may have started anew
    sent_at_.s = -1e9;
    if (!place_.robot.empty() && !std::exchange(has_asked_robot_, true)) put(connectToRobot(place_.robot));
  }
  if (!relay_.isJoined()) said_.clear();  // what a robot said then may not be so any more
  while (const auto packet = relay_.next()) {
    if (packet->event != kTheirEvent) continue;
    if (saysConnected(packet->body)) sent_target_.reset();  // a robot has no target until it is connected
    const std::string words = robotWords(packet->body);
    if (words.empty()) continue;
    std::string& said = said_[packet->body["topic"].get<std::string>()];
    if (said != words) log(said = words);
  }
}

/// Logs a line, at most some a second: a robot may say anything.
void InvesaliusOutput::log(const std::string& words) {
  const Timestamp now = Timestamp::now();
  if (now - second_began_ > 1) second_began_ = now, lines_ = 0;
  if (++lines_ <= kMostLines) logInfo(name() + ": " + words);
}

/// A frame in which something is lost or found again is due at once.
bool InvesaliusOutput::isDue(const LiveFrame& frame) const {
  return Timestamp::now() - sent_at_ >= kLeastBetween_s ||
         trackerPoses(frame).data["visibilities"] != sent_visible_;
}

void InvesaliusOutput::send(const LiveFrame& frame) {
  if (!relay_.isJoined()) return;
  if (!relay_.isFree()) return count(0, 1, relay_.waiting());
  if (!isDue(frame)) return;
  const auto poses = trackerPoses(frame);
  sent_visible_ = poses.data["visibilities"];
  sent_at_ = Timestamp::now();
  put(poses);  // first: the robot's program places the target by the head's newest pose
  sendTarget(frame);
  for (const auto& message : frameMessages(frame)) put(message);
  count(1, 0, relay_.waiting());
}

/// Sends a new or changed target, or that there is none any more. A lost head changes nothing.
void InvesaliusOutput::sendTarget(const LiveFrame& frame) {
  if (!frame.mri_T_target) {
    if (sent_target_) put(unsetTarget());
    return sent_target_.reset();
  }
  const auto target = headTarget(frame);
  if (!target || (sent_target_ && (sent_target_->matrix() - target->matrix()).norm() < kSameTarget)) return;
  const auto message = setTarget(frame);
  if (!message) return;
  sent_target_ = target;
  put(*message);
}

/// Every pose is lost, and the target is taken back.
void InvesaliusOutput::finish(const LiveFrame& frame) {
  LiveFrame last = frame;
  last.mri_T_target.reset();
  if (relay_.isJoined()) {
    put(trackerPoses(last));
    if (sent_target_) {
      for (const auto& message : frameMessages(frame)) put(message);  // not at the target
      put(unsetTarget());
    }
    relay_.leave(kLeave_ms);
  }
}

void InvesaliusOutput::tell() {
  std::string words = relay_.words();
  for (const auto& [topic, said] : said_) words += ", " + said;
  if (words == told_) return;
  told_ = words;
  setReceivers({words});
}

}  // namespace facenav::links
