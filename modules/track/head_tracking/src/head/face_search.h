#pragma once
// FaceSearch: finds start poses for a fit after the prediction has failed. First a coarse fit from the
// expected pose. If that fails, a search of the images (coarse_search.h), some of the views per frame. The
// work of a frame is limited, and counted in patch comparisons instead of timed, so that the same frames give
// the same poses. A start that is found when the budget is used up is tried in the next frame, in that
// frame's images.

#include <optional>
#include <vector>

#include "coarse_search.h"
#include "facenav/core/frame_work.h"
#include "key_frames.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

/// The head's part of a frame's work. `left_out`: patch comparisons reserved for another tracker.
struct HeadWork : FrameWork {
  int left_out = 0;
  bool leavesTimeToSearch() const;
  bool leavesTimeToFit() const;
  /// Steps on the fit's last level that still fit into the frame's budget.
  int stepsLeft(const PatchModel& model) const;
};

class FaceSearch {
 public:
  struct Found {
    PoseFit best;  // fit down to a coarse level
    bool is_anything_alike = false, is_swapped = false;
    bool is_to_be_tried =
        false;  // in this frame; false: nothing is likely enough, or deferred to the next frame
    bool is_deferred = false;
  };

  FaceSearch() = default;
  FaceSearch(const cameras::StereoRig& rig, const PatchModel& model, const std::array<ImagePyramid, 2>& key,
             FaceTemplate face);

  /// `last`: the head's last pose; `expected`: its predicted pose; both if known. `is_first`: first frame
  /// since the loss. Adds to `work`.
  Found seek(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now,
             const std::optional<Eigen::Isometry3d>& last, const std::optional<Eigen::Isometry3d>& expected,
             bool is_first, HeadWork& work);
  /// Sets the start for the next frame to a fit that was converging.
  void goOnFrom(const Eigen::Isometry3d& motion) { deferred_ = motion; }
  /// Resets the search, because the head was found.
  void end() { turn_ = 0, deferred_.reset(); }
  /// Adds the face as seen at `motion` to the search.
  void add(const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& motion);
  void forgetLearnt();
  /// Pyramid level at which fits end that only choose a start.
  int roughLevel() const { return rough_level_; }

 private:
  PoseFit roughly(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now,
                  const Eigen::Isometry3d& start, HeadWork& work, int first_level = kLevels - 1) const;
  void searchFrom(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now, const EvenedPair& evened,
                  const std::optional<Eigen::Isometry3d>& from, Found& found, HeadWork& work) const;

  cameras::StereoRig rig_;
  const PatchModel* model_ = nullptr;  // owned by the tracker
  CoarseSearch coarse_, reference_;    // reference_: without views learnt since the start
  int rough_level_ = 2, turn_ = 0;
  std::optional<Eigen::Isometry3d> deferred_;
};

}  // namespace facenav::head_tracking
