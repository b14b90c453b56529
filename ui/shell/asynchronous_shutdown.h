#pragma once
// AsynchronousShutdown: ends cameras and sessions on threads of their own. A camera that hangs ends late or
// never, and the window must not wait for it. A working camera ends within one frame and can be opened again
// right after.

#include <chrono>
#include <functional>
#include <future>
#include <vector>

namespace facenav::ui {

class AsynchronousShutdown {
 public:
  /// Runs `end` on its own thread and waits for it at most `patience`.
  void add(std::function<void()> end, std::chrono::milliseconds patience);

 private:
  std::vector<std::future<void>> ends_;  // the destructor waits for these
};

}  // namespace facenav::ui
