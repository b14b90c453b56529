#pragma once
// Where to start the fit when nothing was clicked: orientations around "the face looks at the camera" with
// any roll (or around the guess, or the roll that the hints give), places where the cloud is dense, each
// fitted coarsely on the field; the best distinct ones win.

#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/registration/aligner.h"
#include "fit/field_fit.h"

namespace facenav::registration {

struct Candidate {
  Eigen::Isometry3d mri_T_camera;
  double cost = 0.0;
};

enum class SearchWidth {
  near,      // around the guess or the hints; the same as `any` where there are none
  any,       // any roll
  thorough,  // finer turns, more places: for what a first search missed
};

/// Up to `most` candidates that differ by more than 6 degrees or 12 mm, refined to a few mm, best first; at
/// least one. Throws Error("not aligned: ...") when nothing in the cloud looks like this head seen from the
/// front.
std::vector<Candidate> findStarts(const ScalpField& scalp, const PointCloud<Camera>& face,
                                  const AlignmentStart& start, SearchWidth width, std::size_t most,
                                  TaskMonitor& monitor);

/// The guess, or what the hints amount to, fitted from far to near without a search; nothing where there is
/// neither, or where it does not lead onto the face.
std::optional<Candidate> descend(const ScalpField& scalp, const PointCloud<Camera>& face,
                                 const AlignmentStart& start);

/// Those of the `points` within `reach_mm` of the skin at this pose, before any robust weighing.
std::vector<int> nearHead(const ScalpField& scalp, const PointCloud<Camera>& face,
                          const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera,
                          double reach_mm);

}  // namespace facenav::registration
