#include "facenav/session/evidence_keeper.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "facenav/casefile/evidence.h"
#include "facenav/core/later_answer.h"
#include "facenav/core/log.h"

namespace facenav::session {
namespace {

// Half a second at 60 frames/s (kLongestWait_s): 20 MB at 640 x 480, 59 at 1280 x 720, 147 at 1920 x 1200.
constexpr std::size_t kPicturesKept = 32;
constexpr std::size_t kMostWaiting = 60;  // some 40 MB of pictures

/// Returns the frame with number and time as in the session's files; in a continued session they differ from
/// the source's.
cameras::StereoFrame asLogged(const NavigationState& state) {
  cameras::StereoFrame frame = *state.images;
  frame.number = state.frame;
  frame.captured = state.captured;
  return frame;
}

}  // namespace

struct EvidenceKeeper::Implementation {
  Implementation(const std::filesystem::path& folder, const cameras::StereoRig& rig)
      : evidence(folder, rig) {}

  casefile::EvidenceFolder evidence;  // used only by the thread
  mutable std::mutex mutex;           // guards the members below, up to `is_stopping`
  std::condition_variable changed;
  std::deque<cameras::StereoFrame> newest, waiting;  // the pictures are shared, not copied
  std::int64_t last_asked = -1;
  int kept = 0, left_out = 0;
  std::string failure;
  bool is_stopping = false;
  std::thread thread;

  void run();
  void keep(const cameras::StereoFrame& frame);
};

void EvidenceKeeper::Implementation::keep(const cameras::StereoFrame& frame) {
  std::string fault;
  bool is_kept = false;
  try {
    is_kept = evidence.keep(frame);
  } catch (const std::exception& error) {
    fault = error.what();
  }
  std::lock_guard lock(mutex);
  if (!fault.empty() && failure.empty()) logWarning("a pulse's pictures are not kept: " + fault);
  failure = fault;
  kept += is_kept;
  left_out += !fault.empty();
}

void EvidenceKeeper::Implementation::run() {
  runInBackground();
  for (;;) {
    cameras::StereoFrame frame;
    {
      std::unique_lock lock(mutex);
      changed.wait(lock, [this] { return !waiting.empty() || is_stopping; });
      if (waiting.empty()) return;
      frame = std::move(waiting.front());
      waiting.pop_front();
    }
    keep(frame);
  }
}

EvidenceKeeper::EvidenceKeeper(const std::filesystem::path& session_folder, const cameras::StereoRig& rig)
    : implementation_(std::make_unique<Implementation>(session_folder, rig)) {
  implementation_->thread = std::thread([i = implementation_.get()] { i->run(); });
}

EvidenceKeeper::~EvidenceKeeper() {
  {
    std::lock_guard lock(implementation_->mutex);
    implementation_->is_stopping = true;
  }
  implementation_->changed.notify_all();
  implementation_->thread.join();
}

void EvidenceKeeper::follow(const NavigationState& state) {
  if (state.frame < 0 || !state.images || state.images->left.empty() || state.images->right.empty()) return;
  std::lock_guard lock(implementation_->mutex);
  auto& newest = implementation_->newest;
  if (!newest.empty() && newest.back().number >= state.frame) return;  // the last state again
  newest.push_back(asLogged(state));
  if (newest.size() > kPicturesKept) newest.pop_front();
}

void EvidenceKeeper::add(const casefile::Pulse& pulse) {
  if (!pulse.frames) return;  // no picture was taken near the pulse
  const std::int64_t wanted = (*pulse.frames)[pulse.fraction < 0.5 ? 0 : 1];
  {
    std::lock_guard lock(implementation_->mutex);
    auto& i = *implementation_;
    if (wanted <= i.last_asked) return;  // several pulses share a frame
    const auto found = std::find_if(i.newest.begin(), i.newest.end(),
                                    [&](const auto& frame) { return frame.number == wanted; });
    if (found == i.newest.end() || i.waiting.size() >= kMostWaiting) {
      ++i.left_out;
      return;
    }
    i.last_asked = wanted;
    i.waiting.push_back(*found);
  }
  implementation_->changed.notify_one();
}

int EvidenceKeeper::kept() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->kept;
}

int EvidenceKeeper::leftOut() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->left_out;
}

std::string EvidenceKeeper::failure() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->failure;
}

}  // namespace facenav::session
