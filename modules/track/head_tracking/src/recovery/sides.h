#pragma once
// EpipolarOffset: whether both images of a pair are of one moment, decided from the skin. A point found in
// both cameras lies on its epipolar line, whatever the expression, unless head or skin moved between the two
// exposures. A rigid motion of the head shifts the whole face off its lines; a grimace shifts a part of it.

#include <optional>
#include <vector>

#include "facenav/core/timestamp.h"
#include "skin_points.h"

namespace facenav::head_tracking {

struct EpipolarOffset {
  int points = 0;        // found in both cameras
  double median_px = 0;  // signed distance from the epipolar lines, right camera
  double spread_px = 0;  // robust standard deviation about the median
  /// An offset that matters. A head that moved so far across the lines between the exposures, and as far
  /// along them, has a wrong depth (StepLimits::step_harm_mm). At least the calibration's own error.
  double harmful_px = 0;

  /// True if the face's epipolar error is larger than the errors of the matches explain. `allowed_px`: error
  /// that the head's motion between the exposures of untriggered cameras explains.
  bool isOutOfStep(double allowed_px = 0.0) const;
  /// The offset of the whole face and of its parts together, without the noise of single matches.
  double size_px() const;
  /// True if the points lie on their lines so well that both images must be of one moment.
  bool isClean() const;
  /// Tests against a stricter limit, for a face that is not known to be the patient's. Chance matches on
  /// another person's skin do not reach it.
  bool isClearlyOutOfStep() const;
};

/// Motion of a point across its epipolar lines, mm (Camera). Two moments make depth wrong by far more than
/// the head moved, so only this part of a measured motion is the head's own.
double motionAcrossLines_mm(const cameras::StereoRig& rig, const Eigen::Vector3d& from_mm,
                            const Eigen::Vector3d& to_mm);

enum class StepVerdict { in_step, unsure, out_of_step };

/// StepWatch: judges each answer's offset together with the one before, since compressed images shift a
/// single answer by some tenths of a pixel. An offset of twice the limit is judged alone. Within a second
/// after two moments no answer is sure.
class StepWatch {
 public:
  StepVerdict judge(const EpipolarOffset& offset, double allowed_px, Timestamp captured);

 private:
  std::optional<EpipolarOffset> before_;
  Timestamp captured_;
  std::optional<Timestamp> out_;  // the last pair of two moments
};

/// Offset of the matches of a pose's last search (RecoveryPose::matches).
EpipolarOffset epipolarOffset(const cameras::StereoRig& rig, const std::vector<SkinMatch>& matches);

}  // namespace facenav::head_tracking
