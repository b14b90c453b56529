#pragma once
// Retirement: where cameras and sessions go to end. A camera that hangs ends late or never, and the window
// must not wait for it; one that is well ends within a picture, and may be opened again right after.

#include <chrono>
#include <functional>
#include <future>
#include <vector>

namespace facenav::ui {

class Retirement {
 public:
  /// Runs `end` on a thread of its own and waits for it, but no longer than `patience`.
  void add(std::function<void()> end, std::chrono::milliseconds patience);

 private:
  std::vector<std::future<void>> ends_;  // waited for when this goes
};

}  // namespace facenav::ui
