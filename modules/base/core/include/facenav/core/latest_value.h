#pragma once
// LatestValue<T>: hands the newest value from one thread to others. Older values are overwritten, never
// queued; overwritten values are counted. Values are shared as immutable shared_ptr<const T>, so the lock is
// held only while a pointer is swapped.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>

namespace facenav {
inline namespace core {

template <class T>
class LatestValue {
 public:
  using Pointer = std::shared_ptr<const T>;

  void publish(Pointer value) {
    {
      std::lock_guard lock(mutex_);
      if (is_unread_) ++dropped_;
      value_ = std::move(value);
      is_unread_ = true;
    }
    changed_.notify_all();
  }
  /// The newest value, taken or not; null before the first one.
  Pointer latest() const {
    std::lock_guard lock(mutex_);
    return value_;
  }
  /// Waits for a value that was not taken before; null on time-out or after close().
  Pointer take(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, timeout, [this] { return is_unread_ || is_closed_; });
    if (!is_unread_) return nullptr;
    is_unread_ = false;
    return value_;
  }
  /// Waits for another value than `seen`, without taking it; null on time-out.
  Pointer newerThan(const Pointer& seen, std::chrono::milliseconds timeout) const {
    std::unique_lock lock(mutex_);
    const bool is_there = changed_.wait_for(lock, timeout, [&] { return value_ != seen; });
    return is_there ? value_ : nullptr;
  }
  void close() {
    {
      std::lock_guard lock(mutex_);
      is_closed_ = true;
    }
    changed_.notify_all();
  }
  bool isClosed() const {
    std::lock_guard lock(mutex_);
    return is_closed_;
  }
  /// Values overwritten before anyone took them.
  std::uint64_t dropped() const {
    std::lock_guard lock(mutex_);
    return dropped_;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  Pointer value_;
  bool is_unread_ = false;
  bool is_closed_ = false;
  std::uint64_t dropped_ = 0;
};

}  // namespace core
}  // namespace facenav
