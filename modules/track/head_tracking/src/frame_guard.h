#pragma once
// FrameGuard: refuses pairs without new information: black, blank, of another size, or frozen.
//
// A frozen camera repeats its image bit for bit. With sensor noise two images are never equal, so repetition
// in a stream that has shown noise is a freeze, from the first repeated image on. Without noise (a rendered
// recording) a still head repeats its images too, and its pose is right. Repetition is then a freeze only if
// the head was moving before, or if the other camera's view of the face still changes.

#include <cstdint>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/core/tracked.h"
#include "facenav/head_tracking/loss_detail.h"

namespace facenav::head_tracking {

class FrameGuard {
 public:
  void start(const cameras::StereoFrame& reference);
  /// The fault of the pair, or nothing. `speed_mm_s`: of the head as last tracked; the rectangles: the face's
  /// last place in each image.
  std::optional<LostReason> check(const cameras::StereoFrame& frame, double speed_mm_s,
                                  const cv::Rect& left_face, const cv::Rect& right_face);
  /// Detail of check()'s last fault: frozen, or no picture.
  LossDetail detail() const { return detail_; }

 private:
  struct Change {
    double all = 0.0, face = 0.0;  // share of pixels (of some rows) that differ from the previous pair
  };
  static Change change(const cv::Mat& now, const cv::Mat& before, const cv::Rect& face);
  bool streamIsNoisy() const;
  std::optional<LostReason> judge(const Change& left, const Change& right, double moved_mm);

  cv::Size size_;
  cv::Mat left_, right_;      // some rows of the previous images
  double new_image_s_ = 0.0;  // time of the last pair with two new images
  LossDetail detail_ = LossDetail::unknown;
  std::vector<float> changed_;  // the smaller share of left and right, of recent pairs that differed
};

}  // namespace facenav::head_tracking
