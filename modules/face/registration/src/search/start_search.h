#pragma once
// Finds start poses for the fit without a click. Orientations: facing the camera with any roll,
// or around the guess, or with the roll of the hints. Positions: where the cloud is dense. Each is fitted
// coarsely on the field; the best distinct ones are kept.

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
  near,      // around the guess or the hints; `any` without them
  any,       // any roll
  thorough,  // smaller turns and more positions, after a failed first search
};

/// Up to `most` candidates, at least one, that differ by more than 6 degrees or 12 mm, refined to a few mm,
/// best first. Throws Error("not aligned: ...") if nothing in the cloud resembles this head seen from the
/// front.
std::vector<Candidate> findStarts(const ScalpField& scalp, const PointCloud<Camera>& face,
                                  const AlignmentStart& start, SearchWidth width, std::size_t most,
                                  TaskMonitor& monitor);

/// Fits the guess, or the pose of the hints, from far to near without a search. Returns nothing without
/// either, or if it does not lead to the face.
std::optional<Candidate> descend(const ScalpField& scalp, const PointCloud<Camera>& face,
                                 const AlignmentStart& start);

/// The `points` within `reach_mm` of the skin at this pose, without robust weights.
std::vector<int> nearHead(const ScalpField& scalp, const PointCloud<Camera>& face,
                          const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera,
                          double reach_mm);

}  // namespace facenav::registration
