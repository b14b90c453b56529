#pragma once
// The contract of every PulseSource (links/pulse_source.h). A test provides a source and a way to make it
// pulse.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <mutex>
#include <thread>

#include "facenav/links/pulse_source.h"

namespace facenav::testing {

/// Collects the pulses that a source reports, from any thread.
class HeardPulses {
 public:
  links::PulseListener listener() {
    return {[this](const links::PulseTrigger& trigger) {
              const std::lock_guard lock(mutex_);
              triggers_.push_back(trigger);
            },
            [this](const std::string& words) {
              const std::lock_guard lock(mutex_);
              problems_.push_back(words);
            }};
  }
  std::vector<links::PulseTrigger> triggers() const {
    const std::lock_guard lock(mutex_);
    return triggers_;
  }
  std::vector<std::string> problems() const {
    const std::lock_guard lock(mutex_);
    return problems_;
  }
  bool waitFor(std::size_t count) const {
    for (int i = 0; i < 2000 && triggers().size() < count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return triggers().size() == count;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<links::PulseTrigger> triggers_;
  std::vector<std::string> problems_;
};

/// Checks the contract. `pulse` makes the source's device pulse once. `least_between_s`: least time between
/// two separate pulses.
inline void expectPulseSourceContract(links::PulseSource& source, const std::function<void()>& pulse,
                                      double least_between_s) {
  HeardPulses heard;
  source.start(heard.listener());
  const Timestamp before = Timestamp::now();
  const auto utc_before = std::chrono::system_clock::now();
  pulse();
  ASSERT_TRUE(heard.waitFor(1)) << source.name() << ": one pulse, once";
  const links::PulseTrigger first = heard.triggers().front();
  EXPECT_EQ(first.source, source.name());
  EXPECT_GE(first.at - before, -1e-3);
  EXPECT_LE(first.at - Timestamp::now(), 0);
  const double apart_s = std::chrono::duration<double>(first.utc - utc_before).count() - (first.at - before);
  EXPECT_LT(std::abs(apart_s), 0.01) << "both clocks tell the same moment";
  EXPECT_LE(first.dead_time_s, least_between_s) << "a pulse of a train would be taken for a bounce";

  constexpr int kTrain = 15;  // theta bursts: three pulses at 50 Hz, five times a second
  for (int i = 0; i < kTrain; ++i) {
    std::this_thread::sleep_for(std::chrono::duration<double>(i % 3 == 0 ? 0.16 : least_between_s));
    pulse();
  }
  EXPECT_TRUE(heard.waitFor(1 + kTrain)) << source.name() << " heard " << heard.triggers().size();
  const auto all = heard.triggers();
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_GT(all[i].at - all[i - 1].at, 0) << i;
  source.stop();
  source.stop();
  const std::size_t heard_by_then = heard.triggers().size();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(heard.triggers().size(), heard_by_then) << "nothing follows stop()";
  HeardPulses again;
  source.start(again.listener());
  pulse();
  EXPECT_TRUE(again.waitFor(1)) << "after a second start";
  source.stop();
}

}  // namespace facenav::testing
