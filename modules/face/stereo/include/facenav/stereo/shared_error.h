#pragma once
// SharedError: the correlated part of a face cloud's predicted deviation (FaceCloud::sigma_mm), shared by
// neighbouring points and by the whole face. It does not average out, and an alignment's residuals do not
// show the part that the whole face shares. Judge a change by the share of alignments inside their bound
// (`facenav evaluate --scenario plain_align`), on heads and seeds that the evidence does not name.

#include "facenav/core/setting.h"

namespace facenav::stereo {

struct SharedError {
  static constexpr const char* kModule = "stereo";
  static constexpr const char* kSubject = "error that the points of a face share";

  double smooth = 0.25, whole = 0.36, reach_mm = 40;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kFaces("smooth", 0, 5, "1",
                   "what neighbours of a face cloud are off alike, by the deviation that the cloud states"),
            self.smooth);
    visitor(kFaces("reach_mm", 1, 200, "mm", "how far neighbours share it (Matern 3/2)"), self.reach_mm);
    visitor(kFaces("whole", 0, 5, "1", "what the whole face is off along the view, by that deviation"),
            self.whole);
  }

 private:
  static constexpr Evidence kFaces{
      Origin::fitted,
      "on clouds of one real face without dots, five moments, each by two pairs of real cameras: product of "
      "the differences at 16 to 64 mm from each other, and root mean square of their means (-0.76, -0.16, "
      "-0.11, -0.09, -0.11 mm, 0.72 mm stated); no other head was used; taken to hold with dots and for "
      "films "
      "too; to be judged by evaluate's plain_align"};
};

}  // namespace facenav::stereo
