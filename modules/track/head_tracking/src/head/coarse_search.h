#pragma once
// CoarseSearch: finds a lost face by its appearance alone. The face's template (face_template.h) is rotated
// as a head can turn (yaw, nod, lean, and the sides learnt since the start). It is compared at every place of
// the left image at an eighth of the size, then at every depth in the right one. The likeliest places are
// fitted. It needs no face detector, which fails on an occluded or cut face and takes tens of milliseconds.
// Each frame tests some of the views, so that its work stays small.

#include <array>
#include <optional>
#include <vector>

#include "face_template.h"

namespace facenav::head_tracking {

class CoarseSearch {
 public:
  CoarseSearch() = default;
  CoarseSearch(const cameras::StereoRig& rig, const std::array<ImagePyramid, 2>& key, FaceTemplate face);

  struct Places {
    std::vector<Eigen::Isometry3d> starts;  // motions since the reference, the likeliest first
    int comparisons = 0;  // work, in patch comparisons that take the same time (frame_work.h)
  };
  /// Approximate motions of the head, to some degrees: from the `expected` one, and from a search of the
  /// images. `turn` counts up from 0 while the face is lost; each turn searches the next views (turn 0: only
  /// the expected motion, if given). Empty if nothing in both images resembles the face.
  Places find(const cameras::StereoRig& rig, const EvenedPair& now,
              const std::optional<Eigen::Isometry3d>& expected, int turn) const;
  /// Adds the face as seen at `motion` (a key frame) to the search.
  void add(const cameras::StereoRig& rig, const std::array<ImagePyramid, 2>& now,
           const Eigen::Isometry3d& motion);

 private:
  /// The rotated face: some of its points relative to its centre, in pixels of the coarsest level.
  struct View {
    struct Point {
      Eigen::Vector2f from_centre;
      float value;
    };
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    std::size_t appearance = 0;
    std::array<std::vector<Point>, 2> points;  // per camera
  };
  struct Candidate {
    std::size_t appearance = 0;
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    double likeness = 0.0;
  };
  class SearchImage;

  View viewAt(const cameras::StereoRig& rig, const Eigen::Isometry3d& motion, std::size_t appearance) const;
  std::optional<Candidate> locate(const cameras::StereoRig& rig, const std::array<SearchImage, 2>& images,
                                  const View& view, double scale) const;

  /// The likeliest places over these views, each scaled by `scale`.
  std::vector<Candidate> likelyPlaces(const cameras::StereoRig& rig, const EvenedPair& now, std::size_t first,
                                      std::size_t end, double scale) const;
  /// Index in appearances_ of the view nearest to `motion`.
  std::size_t likeliest(const Eigen::Isometry3d& motion) const;

  FaceTemplate face_;
  std::vector<FaceTemplate::Appearance> appearances_;  // the reference's appearance, then the learnt ones
  std::vector<View> views_;                            // learnt ones first, then by angle from the reference
};

}  // namespace facenav::head_tracking
