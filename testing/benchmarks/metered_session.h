#pragma once
// Trackers whose time is measured inside a running session, and a recording in memory that a session plays as
// if from cameras, with pulses by its own clock. For session_benchmark.cpp.

#include <condition_variable>
#include <ctime>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "facenav/capture/recording_pictures.h"
#include "facenav/capture/swinging_source.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/links/pulse_source.h"
#include "support/stopwatch.h"

namespace facenav::benchmarks {

constexpr double kFramesPerSecond = 60.0;

/// Processor time of the calling thread.
inline double threadTime_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

/// Times of the frames since the last take(): wall clock of head and coil, and all of the tracking thread's
/// processor time.
struct Times {
  std::vector<double> wall_ms, thread_ms;
};

class Meter {
 public:
  void begin() {
    const double now_ms = threadTime_ms();
    std::lock_guard lock(mutex_);
    if (thread_before_ms_ > 0) times_.thread_ms.push_back(now_ms - thread_before_ms_);
    thread_before_ms_ = now_ms;
    begun_ms_ = testing::wall_ms();
  }
  void end() {
    {
      std::lock_guard lock(mutex_);
      times_.wall_ms.push_back(testing::wall_ms() - begun_ms_);
      ++done_;
    }
    is_done_.notify_all();
  }
  void waitFor(std::int64_t frames) {
    std::unique_lock lock(mutex_);
    is_done_.wait_for(lock, std::chrono::seconds(5), [&] { return done_ >= frames; });
  }
  std::int64_t done() const {
    std::lock_guard lock(mutex_);
    return done_;
  }
  Times take() {
    std::lock_guard lock(mutex_);
    return std::exchange(times_, {});
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable is_done_;
  Times times_;
  double thread_before_ms_ = 0, begun_ms_ = 0;
  std::int64_t done_ = 0;
};

class MeteredHead : public head_tracking::HeadTracker {
 public:
  MeteredHead(std::unique_ptr<head_tracking::HeadTracker> inner, std::shared_ptr<Meter> meter)
      : inner_(std::move(inner)), meter_(std::move(meter)) {}
  void start(const cameras::StereoRig& rig, const head_tracking::HeadReference& reference,
             head_tracking::Pace pace) override {
    inner_->start(rig, reference, pace);
  }
  head_tracking::HeadResult track(const cameras::StereoFrame& frame,
                                  const head_tracking::HeadContext& context) override {
    meter_->begin();
    return inner_->track(frame, context);
  }
  std::vector<head_tracking::FaceKeyFrame> learntKeyFrames() const override {
    return inner_->learntKeyFrames();
  }

 private:
  std::unique_ptr<head_tracking::HeadTracker> inner_;
  std::shared_ptr<Meter> meter_;
};

class MeteredCoil : public coil_tracking::CoilTracker {
 public:
  MeteredCoil(std::unique_ptr<coil_tracking::CoilTracker> inner, std::shared_ptr<Meter> meter)
      : inner_(std::move(inner)), meter_(std::move(meter)) {}
  void start(const cameras::StereoRig& rig, const coil_tracking::CoilModel& coil) override {
    inner_->start(rig, coil);
  }
  coil_tracking::CoilResult track(const cameras::StereoFrame& frame,
                                  const coil_tracking::CoilContext& context) override {
    auto result = inner_->track(frame, context);
    meter_->end();
    return result;
  }

 private:
  std::unique_ptr<coil_tracking::CoilTracker> inner_;
  std::shared_ptr<Meter> meter_;
};

/// Source of pulses by the frames' own clock.
class FilmPulses : public links::PulseSource {
 public:
  std::string name() const override { return "film"; }
  void start(links::PulseListener listener) override {
    std::lock_guard lock(mutex_);
    listener_ = std::move(listener);
  }
  void stop() override {
    std::lock_guard lock(mutex_);
    listener_ = {};
  }
  void tell(Timestamp at) {
    links::PulseTrigger pulse;
    pulse.source = name();
    pulse.at = at;
    pulse.dead_time_s = 0.002;
    std::lock_guard lock(mutex_);
    if (listener_.pulse) listener_.pulse(pulse);
  }

 private:
  std::mutex mutex_;
  links::PulseListener listener_;
};

/// A recording in memory.
struct Film {
  cameras::StereoRig rig;
  std::vector<std::shared_ptr<const cameras::StereoFrame>> frames;
};

inline Film filmOf(const std::filesystem::path& recording) {
  capture::RecordingPictures pictures(recording);
  Film film{pictures.rig(), {}};
  for (const auto number : pictures.numbers()) film.frames.push_back(pictures.frame(number));
  return film;
}

struct FilmOrder {
  std::int64_t frames = 0;
  bool is_paced = true;        // 60 frames a second; else the next one as soon as the last one is tracked
  std::int64_t train_of = 40;  // pulses of a train, 10 a second; 0: none
  std::int64_t pause = 0;      // pulses that are left out after a train
};

/// Source that plays a film forwards and backwards.
class FilmSource : public capture::FrameSource {
 public:
  FilmSource(const Film& film, const FilmOrder& order, std::shared_ptr<Meter> meter,
             std::function<void(Timestamp)> pulse)
      : film_(film), order_(order), meter_(std::move(meter)), pulse_(std::move(pulse)) {}
  const cameras::StereoRig& rig() const override { return film_.rig; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    if (number_ >= order_.frames) return nullptr;
    if (!order_.is_paced)
      meter_->waitFor(number_);
    else if (const double wait_s = begin_.s + double(number_) / kFramesPerSecond - Timestamp::now().s;
             wait_s > 0)
      std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    const auto& picture =
        film_.frames[std::size_t(capture::swungFrame(number_, std::int64_t(film_.frames.size())))];
    auto frame = std::make_shared<cameras::StereoFrame>(*picture);
    frame->number = number_++;
    frame->captured = {begin_.s + double(frame->number) / kFramesPerSecond};
    constexpr std::int64_t kFramesPerPulse = 6;
    const bool is_pulse =
        pulse_ && order_.train_of > 0 && frame->number % kFramesPerPulse == 3 &&
        frame->number / kFramesPerPulse % (order_.train_of + order_.pause) < order_.train_of;
    if (is_pulse) pulse_({frame->captured.s + 0.004});
    return frame;
  }

 private:
  const Film& film_;
  FilmOrder order_;
  std::shared_ptr<Meter> meter_;
  std::function<void(Timestamp)> pulse_;
  std::int64_t number_ = 0;
  Timestamp begin_ = Timestamp::now();
};

}  // namespace facenav::benchmarks
