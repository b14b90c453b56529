#include "threaded_source.h"

#include <fcntl.h>
#include <unistd.h>

#include <utility>

#include "facenav/core/error.h"
#include "facenav/core/log.h"

namespace facenav::links {

void ThreadedSource::start(PulseListener listener) {
  stop();
  listener_ = std::move(listener);
  told_.clear();
  is_stopping_ = false;
  if (::pipe2(wake_, O_CLOEXEC | O_NONBLOCK) != 0)
    throw Error("no pipe can be made", name_, "close other programs");
  try {
    open();
  } catch (...) {
    close();
    for (int& end : wake_) ::close(std::exchange(end, -1));
    throw;
  }
  thread_ = std::thread([this] {
    try {
      run();
    } catch (const std::exception& error) {  // an exception in a thread must not end the program
      logWarning("pulse source " + name_ + ": " + error.what());
      tellProblem(error.what());
    }
  });
}

void ThreadedSource::stop() {
  if (!thread_.joinable()) return;
  is_stopping_ = true;
  const char any = 0;
  (void)!::write(wake_[1], &any, 1);
  thread_.join();
  close();
  for (int& end : wake_) ::close(std::exchange(end, -1));
}

void ThreadedSource::waitFor(std::vector<pollfd>& descriptors, int wait_ms) const {
  descriptors.push_back({wake_[0], POLLIN, 0});
  ::poll(descriptors.data(), descriptors.size(), wait_ms);
  descriptors.pop_back();
}

void ThreadedSource::waitFor(int wait_ms) const {
  std::vector<pollfd> none;
  waitFor(none, wait_ms);
}

void ThreadedSource::tellPulse(double age_s, std::optional<double> intensity_pct,
                               const std::string& coil) const {
  PulseTrigger trigger;
  trigger.source = name_;
  trigger.at.s -= age_s;
  trigger.utc -=
      std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::duration<double>(age_s));
  trigger.dead_time_s = dead_time_s_;
  trigger.intensity_pct = intensity_pct;
  trigger.coil = coil;
  if (listener_.pulse && !is_stopping_) listener_.pulse(trigger);
}

void ThreadedSource::tellProblem(const std::string& words) {
  if (words == told_ || is_stopping_) return;
  told_ = words;
  if (listener_.problem) listener_.problem(words);
}

}  // namespace facenav::links
