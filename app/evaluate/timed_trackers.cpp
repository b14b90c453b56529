#include "evaluate/timed_trackers.h"

#include <algorithm>
#include <opencv2/core/utility.hpp>

#include "facenav/core/parallel_for.h"
#include "facenav/core/processor_time.h"

namespace facenav::app {
namespace {

/// Measures the processor time of a scope, and limits it to one thread, OpenCV's loops included.
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
  void start(const cameras::StereoRig& rig, const head_tracking::HeadReference& reference) override {
    tracker_->start(rig, reference);
  }
  Tracked<head_tracking::HeadPose> track(const cameras::StereoFrame& frame) override {
    auto pose = [&] {
      const OneThreadClock clock(last_);
      return tracker_->track(frame);
    }();
    last_.ms = std::max(0.0, last_.ms - tracker_->beside_ms());  // live, this runs on other threads
    return pose;
  }
  void setPace(head_tracking::Pace pace) override { tracker_->setPace(pace); }
  double beside_ms() const override { return tracker_->beside_ms(); }
  head_tracking::LossDetail lossDetail() const override { return tracker_->lossDetail(); }
  head_tracking::ExposureOffset exposureOffset() const override { return tracker_->exposureOffset(); }
  FrameWork work() const override { return tracker_->work(); }
  void leave(const FrameWork& work) override { tracker_->leave(work); }
  void forgetLearnt() override { tracker_->forgetLearnt(); }

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
  Tracked<coil_tracking::CoilPose> track(const cameras::StereoFrame& frame) override {
    const OneThreadClock clock(last_);
    return tracker_->track(frame);
  }
  void setRightLate(double late_s, double sigma_s) override { tracker_->setRightLate(late_s, sigma_s); }
  void setWorkBefore(const FrameWork& work) override { tracker_->setWorkBefore(work); }
  FrameWork work() const override { return tracker_->work(); }
  FrameWork putOff() const override { return tracker_->putOff(); }
  std::optional<coil_tracking::MarkerSighting> sighting() const override { return tracker_->sighting(); }

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
