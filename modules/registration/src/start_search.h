#pragma once
// Where to start the fit when nothing was clicked: orientations around "the face looks at the camera" with
// any roll (or the roll that the hints give), places where the cloud is dense, each tried coarsely; the best
// distinct ones win.

#include <vector>

#include "pose_fit.h"

namespace facenav::registration {

struct Candidate {
  Eigen::Isometry3d mri_T_camera;
  double cost = 0.0;
};

struct SearchExtent {
  bool use_hints = true;     // start from the hints' roll and nose; otherwise any roll
  std::size_t most = 6;      // candidates returned, best first
  bool is_thorough = false;  // finer turns, more places: for what the first search missed
  bool is_refined = true;    // by point-to-plane fits; otherwise rough, within about 15 mm and 10 degrees
};

/// Candidates that differ by more than 6 degrees or 12 mm, refined to a few mm; at least one. Throws
/// Error("not aligned: ...") when nothing in the cloud looks like this head seen from the front.
std::vector<Candidate> findStarts(const SkinField& skin, const PointCloud<Camera>& face,
                                  const AlignmentStart& start, const SearchExtent& extent,
                                  TaskMonitor& monitor);

/// Indices of the cloud's points within `reach_mm` of the skin at this pose, before any robust weighing.
std::vector<int> nearHead(const SkinField& skin, const PointCloud<Camera>& face,
                          const Eigen::Isometry3d& mri_T_camera, double reach_mm);

/// Do the two poses put the head in different places (more than `rotation_rad` or `distance_mm` at
/// `pivot_mri`)?
bool areDistinct(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const Eigen::Vector3d& pivot_mri_mm,
                 double rotation_rad, double distance_mm);

}  // namespace facenav::registration
