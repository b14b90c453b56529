#include "evaluate/timed_trackers.h"

#include <algorithm>
#include <opencv2/core/utility.hpp>

#include "facenav/core/parallel_for.h"
#include "facenav/core/processor_time.h"

namespace facenav::app {
namespace {

/// Measures the processor time of a scope, and limits it to one thread, including OpenCV's loops.
class OneThreadClock {
 public:
  explicit OneThreadClock(LastCall& last) : last_(last), threads_(cv::getNumThreads()) {
    cv::setNumThreads(1);
    start_ms_ = processorTime_ms();
  }
  ~OneThreadClock() {
    last_.ms = processorTime_ms() - start_ms_;
    cv::setNumThreads(threads_);
  }
  OneThreadClock(const OneThreadClock&) = delete;
  OneThreadClock& operator=(const OneThreadClock&) = delete;

 private:
  LastCall& last_;
  const OneCoreOnly one_core_;
  int threads_;
  double start_ms_ = 0.0;
};

class TimedHeadTracker : public head_tracking::HeadTracker {
 public:
  TimedHeadTracker(std::unique_ptr<head_tracking::HeadTracker> tracker, LastCall& last)
      : tracker_(std::move(tracker)), last_(last) {}
  void start(const cameras::StereoRig& rig, const head_tracking::HeadReference& reference,
             head_tracking::Pace pace) override {
    tracker_->start(rig, reference, pace);
  }
  head_tracking::HeadResult track(const cameras::StereoFrame& frame,
                                  const head_tracking::HeadContext& context) override {
    auto result = [&] {
      const OneThreadClock clock(last_);
      return tracker_->track(frame, context);
    }();
    last_.ms = std::max(0.0, last_.ms - result.beside_ms);  // in a live session this runs on other threads
    return result;
  }

 private:
  std::unique_ptr<head_tracking::HeadTracker> tracker_;
  LastCall& last_;
};

class TimedCoilTracker : public coil_tracking::CoilTracker {
 public:
  TimedCoilTracker(std::unique_ptr<coil_tracking::CoilTracker> tracker, LastCall& last)
      : tracker_(std::move(tracker)), last_(last) {}
  void start(const cameras::StereoRig& rig, const coil_tracking::CoilModel& coil) override {
    tracker_->start(rig, coil);
  }
  coil_tracking::CoilResult track(const cameras::StereoFrame& frame,
                                  const coil_tracking::CoilContext& context) override {
    const OneThreadClock clock(last_);
    return tracker_->track(frame, context);
  }

 private:
  std::unique_ptr<coil_tracking::CoilTracker> tracker_;
  LastCall& last_;
};

class TimedAligner : public registration::Aligner {
 public:
  TimedAligner(std::unique_ptr<registration::Aligner> aligner, LastCall& last)
      : aligner_(std::move(aligner)), last_(last) {}
  registration::AlignmentResult align(const registration::ScalpField& scalp, const PointCloud<Camera>& face,
                                      const registration::AlignmentStart& start,
                                      TaskMonitor& monitor) const override {
    const OneThreadClock clock(last_);
    return aligner_->align(scalp, face, start, monitor);
  }

 private:
  std::unique_ptr<registration::Aligner> aligner_;
  LastCall& last_;
};

}  // namespace

std::unique_ptr<head_tracking::HeadTracker> timed(std::unique_ptr<head_tracking::HeadTracker> tracker,
                                                  LastCall& last) {
  return std::make_unique<TimedHeadTracker>(std::move(tracker), last);
}
std::unique_ptr<coil_tracking::CoilTracker> timed(std::unique_ptr<coil_tracking::CoilTracker> tracker,
                                                  LastCall& last) {
  return std::make_unique<TimedCoilTracker>(std::move(tracker), last);
}
std::unique_ptr<registration::Aligner> timed(std::unique_ptr<registration::Aligner> aligner, LastCall& last) {
  return std::make_unique<TimedAligner>(std::move(aligner), last);
}

}  // namespace facenav::app
