#pragma once
// KeyFrames: the appearance of the patches from several sides. The reference shows the face from one side
// only. If the head has turned by 20 degrees or more, its patches are foreshortened and lit differently. So
// when the head is tracked well from a new side, the same patches (same points on the skin) are learnt again
// there, a few per frame to keep each frame short. A key frame is made once, from the reference or from a key
// frame near it. The error of its own pose is part of the covariance of the poses tracked by it.

#include <deque>
#include <optional>
#include <vector>

#include "patch_model.h"
#include "pose_fit.h"
#include "track_verdict.h"

namespace facenav::head_tracking {

/// Motion of the head while a key frame's images were taken, when the right camera exposes later
/// (OffsetFilter). The position of the patches in the right image depends on it.
struct KeyMotion {
  Vector6d velocity = Vector6d::Zero();  // per s, Head, about the model's centre
  Vector6d allowed = Vector6d::Zero();   // motion from one exposure to the other, as assumed then
};

struct KeyFrame {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  // camera_T_head of the key frame
  Matrix6d covariance = Matrix6d::Zero();                    // of that pose, as in HeadPose
  Matrix6d unseen_covariance = Matrix6d::Zero();             // additional error that no image shows
  int number = 0;                                            // 0: the reference; the next ones count up
  int generation = 0;                                        // 0: the reference
  bool is_of_moment = false;  // temporary: learnt with the present appearance when the face was found again
  KeyMotion moving;           // zero for the reference
  PatchLevels level;          // the coarser levels are used to find the head again on this side
};

class KeyFrames {
 public:
  KeyFrames() = default;
  explicit KeyFrames(const PatchModel& model, int newest = 0);

  /// The key frame with the view closest to that at `motion`. Keeps the last choice when two are about equal.
  const KeyFrame& nearest(const Eigen::Isometry3d& motion);
  /// The key frame with the closest view, without preference for the last choice.
  const KeyFrame& likeliest(const Eigen::Isometry3d& motion) const;

  /// Call after each tracked frame. Continues learning, or starts if the frame shows a new side well (then
  /// returns true). `rig`: with the right camera's pose for this motion of the head.
  bool learn(const cameras::StereoRig& rig, const PatchModel& model, const cameras::StereoFrame& frame,
             const PoseFit& fit, const Verdict& verdict, const KeyMotion& moving);
  /// A key frame of all patches in `frame` at a pose found by other means, made at once (some 100 ms). Empty
  /// if too few patches are visible.
  static std::optional<KeyFrame> ofMoment(const cameras::StereoRig& rig, const PatchModel& model,
                                          const cameras::StereoFrame& frame, const Eigen::Isometry3d& motion,
                                          const Matrix6d& covariance, const Matrix6d& unseen_covariance);
  /// Tracks by `key` from now on. Replaces earlier temporary key frames.
  void startMoment(KeyFrame key);
  /// Drops temporary key frames once the normal appearance returns.
  void endMoment();
  /// Sets whether temporary key frames have priority. Off after a loss: the change of appearance may have
  /// ended.
  void preferMoment(bool is_preferred) { prefers_moment_ = is_preferred; }
  bool isOfMoment() const { return keys_[chosen_].is_of_moment; }
  /// The likeliest key frame that is not temporary.
  const KeyFrame& lasting(const Eigen::Isometry3d& motion) const;

  /// Drops unfinished key frames after a loss of the track: they may be wrong.
  void forgetUnfinished() { unfinished_.clear(); }

  std::size_t size() const { return keys_.size(); }
  /// Number of the last key frame that was begun.
  int newest() const { return newest_; }

 private:
  struct Unfinished {
    KeyFrame key;
    std::array<cv::Mat, 2> image;  // the head's surroundings as recorded
    std::array<cv::Point, 2> origin;
    Eigen::Isometry3d right_T_left;            // of that frame, corrected for its motion (OffsetFilter)
    std::array<ImagePyramid, 2> pyramid;       // of these images; each is made in a frame of its own
    std::vector<std::array<bool, 2>> is_good;  // patches of level 0
    int level = 0;
    std::size_t next = 0;   // next patch
    int usable = 0;         // number of usable views of level 0
    std::size_t index = 0;  // in keys_, once level 0 is learnt
  };

  /// Cuts the surroundings of the head out of a pair, to learn from.
  static Unfinished unfinishedAt(const cameras::StereoRig& rig, const PatchModel& model,
                                 const cameras::StereoFrame& frame, const Eigen::Isometry3d& motion);
  bool isNewSide(const PoseFit& fit, const Verdict& verdict) const;
  void begin(const cameras::StereoRig& rig, const PatchModel& model, const cameras::StereoFrame& frame,
             const PoseFit& fit, const Verdict& verdict, const KeyMotion& moving);
  /// Makes the pyramid of one image per call; false when both are ready.
  bool prepare();
  void goOn(const cameras::StereoRig& rig, const PatchModel& model);
  void learnPatch(const cameras::StereoRig& rig, const PatchModel& model, std::size_t i);
  double cost(std::size_t key, const Eigen::Isometry3d& motion) const;

  std::vector<KeyFrame> keys_;
  std::size_t chosen_ = 0;
  int newest_ = 0;
  bool prefers_moment_ = true;
  std::deque<Unfinished>
      unfinished_;  // the first is being learnt; a new side is placed before older coarse levels
};

}  // namespace facenav::head_tracking
