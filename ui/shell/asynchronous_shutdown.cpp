#include "shell/asynchronous_shutdown.h"

#include <algorithm>

#include "facenav/core/log.h"

namespace facenav::ui {

void AsynchronousShutdown::add(std::function<void()> end, std::chrono::milliseconds patience) {
  const auto has_come = [](const std::future<void>& each) {
    return each.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  ends_.erase(std::remove_if(ends_.begin(), ends_.end(), has_come), ends_.end());
  ends_.push_back(std::async(std::launch::async, [end = std::move(end)] {
    try {
      end();
    } catch (const std::exception& error) {  // no caller to report to
      logWarning(std::string("a session or camera did not end well: ") + error.what());
    }
  }));
  ends_.back().wait_for(patience);
}

}  // namespace facenav::ui
