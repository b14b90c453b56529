#pragma once
// KeyFrames: the looks of the patches from more than one side. The reference shows the face from where it was
// aligned; 20 and more degrees away its patches are foreshortened and lit otherwise. So where the head is
// tracked well and seen from a new side, the same patches (same points on the skin) are learnt anew there, a
// few in each frame so that no frame takes long. A key frame's own error of pose stays with it: it is made
// once, from the reference or from a key frame near it, and counts in the covariance of what it tracks.

#include <deque>
#include <optional>
#include <vector>

#include "patch_model.h"
#include "pose_fit.h"
#include "track_verdict.h"

namespace facenav::head_tracking {

/// Of the head when a key frame's pictures were taken, by a right camera that exposes later (OffsetFilter):
/// its looks in the right image lie where that delay put them.
struct KeyMotion {
  Vector6d velocity = Vector6d::Zero();  // per s, Head, about the model's centre
  Vector6d allowed = Vector6d::Zero();   // how far it was taken to move from one exposure to the other
};

struct KeyFrame {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  // camera_T_head there
  Matrix6d covariance = Matrix6d::Zero();                    // of that, HeadPose's
  Matrix6d unseen_covariance = Matrix6d::Zero();             // besides: what no picture shows
  int generation = 0;                                        // 0: the reference
  bool is_of_moment =
      false;          // learnt where the face was found anew: as it looks now, whatever it looked like
  KeyMotion moving;   // the reference: at rest
  PatchLevels level;  // what is not finest serves to find the head again at this side
};

class KeyFrames {
 public:
  KeyFrames() = default;
  explicit KeyFrames(const PatchModel& model);

  /// The one that shows the head most as it is seen at `motion`; the last one's choice is kept where both are
  /// alike.
  const KeyFrame& nearest(const Eigen::Isometry3d& motion);
  /// The same, whatever was chosen last.
  const KeyFrame& likeliest(const Eigen::Isometry3d& motion) const;

  /// After each tracked frame: goes on learning, or begins to where the frame shows a new side well (true).
  /// `rig`: its right camera as it sees the head moving so.
  bool learn(const cameras::StereoRig& rig, const PatchModel& model, const cameras::StereoFrame& frame,
             const PoseFit& fit, const Verdict& verdict, const KeyMotion& moving);
  /// All patches as `frame` shows them at a pose that was found without them, at once (some 100 ms). Nothing
  /// where too few can be seen.
  static std::optional<KeyFrame> ofMoment(const cameras::StereoRig& rig, const PatchModel& model,
                                          const cameras::StereoFrame& frame, const Eigen::Isometry3d& motion,
                                          const Matrix6d& covariance, const Matrix6d& unseen_covariance);
  /// The head is tracked by `key` from now on, in place of an earlier moment's.
  void startMoment(KeyFrame key);
  /// The face looks again as it did before: key frames of the moment go.
  void endMoment();
  /// Whether a moment's key frames come first (they do, unless it may be over: the face was lost).
  void preferMoment(bool is_preferred) { prefers_moment_ = is_preferred; }
  bool isOfMoment() const { return keys_[chosen_].is_of_moment; }
  /// The likeliest that is no moment's.
  const KeyFrame& lasting(const Eigen::Isometry3d& motion) const;

  /// The track was lost: what is being learnt may be wrong.
  void forgetUnfinished() { unfinished_.clear(); }

  std::size_t size() const { return keys_.size(); }

 private:
  struct Unfinished {
    KeyFrame key;
    std::array<cv::Mat, 2> image;  // of the head's surroundings, as recorded
    std::array<cv::Point, 2> origin;
    Eigen::Isometry3d right_T_left;            // as that frame was seen (OffsetFilter)
    std::array<ImagePyramid, 2> pyramid;       // of these; made in frames of their own
    std::vector<std::array<bool, 2>> is_good;  // of level 0
    int level = 0;
    std::size_t next = 0;   // patch
    int usable = 0;         // of level 0
    std::size_t index = 0;  // in keys_, once level 0 is learnt
  };

  /// Of the head's surroundings in a pair, to learn from.
  static Unfinished unfinishedAt(const cameras::StereoRig& rig, const PatchModel& model,
                                 const cameras::StereoFrame& frame, const Eigen::Isometry3d& motion);
  bool isNewSide(const PoseFit& fit, const Verdict& verdict) const;
  void begin(const cameras::StereoRig& rig, const PatchModel& model, const cameras::StereoFrame& frame,
             const PoseFit& fit, const Verdict& verdict, const KeyMotion& moving);
  /// Makes what is to be learnt from ready, one image a call; true while there was something to do.
  bool prepare();
  void goOn(const cameras::StereoRig& rig, const PatchModel& model);
  void learnPatch(const cameras::StereoRig& rig, const PatchModel& model, std::size_t i);
  double cost(std::size_t key, const Eigen::Isometry3d& motion) const;

  std::vector<KeyFrame> keys_;
  std::size_t chosen_ = 0;
  bool prefers_moment_ = true;
  std::deque<Unfinished> unfinished_;  // the first is being learnt; a new side goes before older coarse looks
};

}  // namespace facenav::head_tracking
