#include "facenav/session/recorder.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "facenav/capture/recording.h"

namespace facenav::session {

struct Recorder::Implementation {
  std::unique_ptr<capture::RecordingWriter> writer;
  std::size_t limit;
  mutable std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::shared_ptr<const cameras::StereoFrame>> queue;
  std::uint64_t written = 0, left_out = 0;
  std::string failure;
  bool is_closing = false, is_abandoned = false;
  std::thread thread;

  std::shared_ptr<const cameras::StereoFrame> next();
  void run();
  void join(bool keep);
};

std::shared_ptr<const cameras::StereoFrame> Recorder::Implementation::next() {
  std::unique_lock lock(mutex);
  changed.wait(lock, [this] { return !queue.empty() || is_closing; });
  if (queue.empty() || is_abandoned) return nullptr;
  auto frame = queue.front();
  queue.pop_front();
  return frame;
}

void Recorder::Implementation::run() {
  try {
    while (auto frame = next()) {
      writer->add(*frame);
      std::lock_guard lock(mutex);
      ++written;
    }
    if (!is_abandoned) writer->close();
  } catch (const std::exception& error) {
    std::lock_guard lock(mutex);
    failure = error.what();
  }
  writer.reset();
}

void Recorder::Implementation::join(bool keep) {
  {
    std::lock_guard lock(mutex);
    is_closing = true;
    is_abandoned = !keep;
  }
  changed.notify_all();
  if (thread.joinable()) thread.join();
}

Recorder::Recorder(const std::filesystem::path& folder, const cameras::StereoRig& rig,
                   std::size_t queue_limit, FileAccess access, const capture::CapturePair* capture)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->writer = std::make_unique<capture::RecordingWriter>(folder, rig, access);
  if (capture) implementation_->writer->setCapture(*capture);
  implementation_->limit = queue_limit;
  implementation_->thread = std::thread([this] { implementation_->run(); });
}

Recorder::~Recorder() {
  if (implementation_->thread.joinable()) implementation_->join(false);
}

void Recorder::add(std::shared_ptr<const cameras::StereoFrame> frame) {
  auto& r = *implementation_;
  {
    std::lock_guard lock(r.mutex);
    if (r.is_closing || !r.failure.empty()) return;
    if (r.queue.size() >= r.limit) {
      ++r.left_out;
      return;
    }
    r.queue.push_back(std::move(frame));
  }
  r.changed.notify_one();
}

void Recorder::close() { implementation_->join(true); }

std::uint64_t Recorder::written() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->written;
}

std::uint64_t Recorder::leftOut() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->left_out;
}

std::string Recorder::failure() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->failure;
}

}  // namespace facenav::session
