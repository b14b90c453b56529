#pragma once
// Compares two sessions of a case: how far the second session's coil was from the first's (return error),
// target by target. Pulses that are excluded or without a pose are ignored.

#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"

namespace facenav::steps {

/// Mean pose of the coil over a session's pulses at one target.
struct MeanCoil {
  RigidTransform<Mri, Coil> mri_T_coil;  // mean of the centres; mean rotation by quaternions (Markley 2007)
  int pulses = 0;
  double spread_mm = 0, spread_deg = 0;  // root mean square of distance and angle of the pulses to that pose
};
/// Computes the mean; nothing if no pulse at the target has a pose.
std::optional<MeanCoil> meanCoil(const std::vector<casefile::ReviewedPulse>& pulses,
                                 const std::string& target);

struct TargetReturn {
  std::string target;
  MeanCoil first, second;
  double distance_mm = 0;  // between the mean centres of the coil
  double tilt_deg = 0;     // between their z axes
  double twist_deg = 0;    // of the handle about z, signed
  double angle_deg = 0;    // of the whole rotation
  // Difference between the targets at the sessions' first pulses: not 0 for a target that was moved.
  double target_moved_mm = 0, target_turned_deg = 0;
  std::optional<double> mep_first_uv, mep_second_uv;  // medians
};

struct SessionComparison {
  std::vector<TargetReturn> targets;                 // in both sessions, in the first one's order
  std::vector<std::string> only_first, only_second;  // names of targets in one session only
};

SessionComparison compareSessions(const std::vector<casefile::ReviewedPulse>& first,
                                  const std::vector<casefile::ReviewedPulse>& second);

}  // namespace facenav::steps
