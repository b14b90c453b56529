#pragma once
// FaceSearch: from where a fit is worth while after the prediction has failed. A coarse fit from what is
// expected; where that leads nowhere, from wherever the face seems to be (coarse_search.h), some of the views
// a frame. What a frame may spend is bounded: counted in looks at a patch, not timed, so that the same frames
// give the same poses. A start that is found when too much is spent is tried in the next frame, in its
// pictures.

#include <optional>
#include <vector>

#include "coarse_search.h"
#include "facenav/core/frame_work.h"
#include "key_frames.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

/// The head's part of a frame's work; `left_out`: looks that are kept for another tracker.
struct HeadWork : FrameWork {
  int left_out = 0;
  bool leavesTimeToSearch() const;
  bool leavesTimeToFit() const;
  /// Of a fit's last level, so that the frame's limit is kept.
  int stepsLeft(const PatchModel& model) const;
};

class FaceSearch {
 public:
  struct Found {
    PoseFit best;  // to a coarse level
    bool is_anything_alike = false, is_swapped = false;
    bool is_to_be_tried = false;  // now; else nothing is likely enough, or it waits for the next frame
    bool is_put_off = false;
  };

  FaceSearch() = default;
  FaceSearch(const cameras::StereoRig& rig, const PatchModel& model, const std::array<ImagePyramid, 2>& key,
             FaceTemplate face);

  /// `last`: where the head was seen last, `expected`: where it should be by now, if either is known.
  /// `is_first`: of the frames since it was seen. Adds to `work`.
  Found seek(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now,
             const std::optional<Eigen::Isometry3d>& last, const std::optional<Eigen::Isometry3d>& expected,
             bool is_first, HeadWork& work);
  /// Where the next frame's search begins: a fit that was getting there.
  void goOnFrom(const Eigen::Isometry3d& motion) { put_off_ = motion; }
  /// The head was found.
  void end() { turn_ = 0, put_off_.reset(); }
  /// The face as it is seen at `motion`, to be looked for, too.
  void add(const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& motion);
  void forgetLearnt();
  /// The level at which fits end that only choose a start.
  int roughLevel() const { return rough_level_; }

 private:
  PoseFit roughly(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now,
                  const Eigen::Isometry3d& start, HeadWork& work, int first_level = kLevels - 1) const;
  void lookFrom(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now, const EvenedPair& evened,
                const std::optional<Eigen::Isometry3d>& from, Found& found, HeadWork& work) const;

  cameras::StereoRig rig_;
  const PatchModel* model_ = nullptr;  // the tracker's
  CoarseSearch coarse_, reference_;    // the second: without what was learnt since the start
  int rough_level_ = 2, turn_ = 0;
  std::optional<Eigen::Isometry3d> put_off_;
};

}  // namespace facenav::head_tracking
