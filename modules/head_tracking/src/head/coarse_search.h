#pragma once
// CoarseSearch: where the face has gone, from its looks alone. The face's template (face_template.h), turned
// as a head turns (yaw, nod, lean, and the sides learnt since), is laid over every place of the left image at
// an eighth of the size, then at every depth over the right one; the likeliest places are fitted. Needs no
// face detector (a covered or cut face has none to offer, and a cascade takes tens of milliseconds); some of
// the views a frame keep each frame short.

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
    int looks = 0;  // what it took, in the time of so many looks at a patch (face_search.h)
  };
  /// Where the head may be, to some degrees: from where it was `expected`, and from where it looks like.
  /// `turn` counts up from 0 while the face is lost: each takes the next views (the first only what is
  /// expected, if anything is). Empty where nothing in both images looks like the face.
  Places find(const cameras::StereoRig& rig, const EvenedPair& now,
              const std::optional<Eigen::Isometry3d>& expected, int turn) const;
  /// The face as it is seen at `motion` (a key frame), to be looked for, too.
  void add(const cameras::StereoRig& rig, const std::array<ImagePyramid, 2>& now,
           const Eigen::Isometry3d& motion);

 private:
  /// The face turned: some of its points about the place of its centre, pixels of the coarsest level.
  struct View {
    struct Point {
      Eigen::Vector2f from_centre;
      float value;
    };
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    std::size_t looks = 0;
    std::array<std::vector<Point>, 2> points;  // of each camera
  };
  struct Candidate {
    std::size_t looks = 0;
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    double likeness = 0.0;
  };
  class SearchImage;

  View viewAt(const cameras::StereoRig& rig, const Eigen::Isometry3d& motion, std::size_t looks) const;
  std::optional<Candidate> locate(const cameras::StereoRig& rig, const std::array<SearchImage, 2>& images,
                                  const View& view, double scale) const;

  /// The likeliest over these views, each as large as `scale` says.
  std::vector<Candidate> likelyPlaces(const cameras::StereoRig& rig, const EvenedPair& now, std::size_t first,
                                      std::size_t end, double scale) const;
  /// The looks of the view most like `motion`.
  std::size_t likeliest(const Eigen::Isometry3d& motion) const;

  FaceTemplate face_;
  std::vector<FaceTemplate::Looks> looks_;  // the reference's, then those learnt
  std::vector<View> views_;                 // the learnt ones first, then by their turn from the reference
};

}  // namespace facenav::head_tracking
