#pragma once
// FrameGuard: is this pair of images news at all? Black, blank, of another size, or frozen.
//
// A frozen camera repeats its image bit for bit. With sensor noise two images are never equal, so repetition
// in a stream that has shown noise is a freeze, from the first repeated image on. Without noise (a rendered
// recording) a still head repeats its images too, and its pose is right: then repetition counts as a freeze
// only where the head was moving before, or where the other camera's view of the face goes on changing.

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
  /// Why the pair cannot be trusted, or nothing. `speed_mm_s`: of the head as last tracked; the rectangles:
  /// where the face was last seen in each image.
  std::optional<LostReason> check(const cameras::StereoFrame& frame, double speed_mm_s,
                                  const cv::Rect& left_face, const cv::Rect& right_face);
  /// Of the fault that check() gave last: frozen, or no picture.
  LossDetail detail() const { return detail_; }

 private:
  struct Change {
    double all = 0.0, face = 0.0;  // share of pixels (of some rows) that differ from before
  };
  static Change change(const cv::Mat& now, const cv::Mat& before, const cv::Rect& face);
  bool streamIsNoisy() const;
  std::optional<LostReason> judge(const Change& left, const Change& right, double moved_mm);

  cv::Size size_;
  cv::Mat left_, right_;      // some rows of the previous images
  double new_image_s_ = 0.0;  // when both images last were new
  LossDetail detail_ = LossDetail::unknown;
  std::vector<float> changed_;  // of recent pairs that differed, the smaller share of left and right
};

}  // namespace facenav::head_tracking
