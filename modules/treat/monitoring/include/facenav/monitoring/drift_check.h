#pragma once
// DriftCheck: tests whether the face is still where it is tracked. It measures the face densely in the plain
// pair (from the skin's own texture; no dots are needed) and fits it, with 6 degrees of freedom, to the MRI's
// skin at the tracked pose. The tracker uses the skin's appearance, this check its shape, so they do not
// share errors: wrong key frames, skin that moved, a head recovered in a wrong place.
// Data flow: StereoFrame + tracked camera_T_mri -> DriftFinding. The misfit between skin and MRI, and the
// bias of stereo without dots, are measured once in the reference pair and subtracted. So the check cannot
// detect a wrong alignment, except for a head that moved before the reference pair: see atReference().

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/registration/scalp_field.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::monitoring {

/// Smallest cosine between normal and view; near the face's outline, stereo mixes it with the background.
constexpr double kObliqueSkin_cos = 0.4;
/// Depth search range beyond the expected skin.
constexpr double kDepthMargin_mm = 20.0;

struct DriftFinding {
  enum class Verdict { agrees, drifted, unknown };  // unknown: too few points on the face
  Verdict verdict = Verdict::unknown;
  double shift_mm = 0.0,
         turn_deg = 0.0;  // measured face relative to the tracked face, at its centre
  double shift_sigma_mm = 0.0, turn_sigma_deg = 0.0;  // their standard errors
  int points = 0;                                     // measured on the face's skin
};

class DriftCheck {
 public:
  /// Builds the check. `reference`: with the surface that was aligned. `camera_T_mri`: the alignment, at that
  /// frame.
  DriftCheck(const cameras::StereoRig& rig, std::shared_ptr<const registration::ScalpField> scalp,
             const head_tracking::HeadReference& reference, const RigidTransform<Camera, Mri>& camera_T_mri);

  /// Finding in the reference pair itself: the offset that is subtracted from all later measurements.
  /// `drifted`, by narrower limits than theirs, means that the head moved between the aligned picture and the
  /// reference.
  const DriftFinding& atReference() const { return at_reference_; }
  /// Measures a frame in some 40 ms. Const, and safe to call beside other threads.
  DriftFinding measure(const cameras::StereoFrame& frame,
                       const RigidTransform<Camera, Mri>& camera_T_mri) const;
  /// Sets the right camera's pose for the next frames; the rig's own at first.
  void moveRight(const RigidTransform<RightCamera, Camera>& right_T_left);

 private:
  /// Map of the reference's skin on a grid of the left reference image: where skin was measured, and how far
  /// it lies outside the MRI's skin.
  struct SkinMap {
    int columns = 0, rows = 0;
    std::vector<float> misfit_mm;  // NaN: no skin was aligned there
    std::optional<float> at(const Eigen::Vector2d& reference_px) const;
  };
  struct Offset {
    // (w rad, v mm) moves the measured face to the tracked one; Head's axes, about the face's centre.
    Vector6d xi = Vector6d::Zero();
    Matrix6d covariance = Matrix6d::Zero();
    int points = 0;
  };
  /// One measured point, with the reference's skin misfit at that point.
  struct Sample {
    Eigen::Vector3d p_mm;  // Camera
    Eigen::Vector2f left_px;
    double misfit_mm, sigma_mm;
  };

  double depthPerPixel_mm(double depth_mm) const;  // depth error per pixel of disparity error
  std::vector<Sample> measureSkin(const cameras::StereoFrame& frame, const Eigen::Isometry3d& motion) const;
  std::optional<Offset> offsetOf(const std::vector<Sample>& samples, const Eigen::Isometry3d& motion) const;

  DriftFinding findingOf(const Offset& offset, const Vector6d& bias, const Eigen::Isometry3d& motion) const;
  cameras::StereoRig rigNow() const;

  cameras::StereoRig rig_;
  mutable std::mutex moving_;
  RigidTransform<RightCamera, Camera> right_T_left_;  // used under moving_
  std::shared_ptr<const registration::ScalpField> scalp_;
  Eigen::Isometry3d mri_T_head_;
  std::vector<Eigen::Vector3d> surface_mm_;  // sample of the reference's surface, Head
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  SkinMap skin_;
  Vector6d bias_ = Vector6d::Zero();  // the offset measured in the reference pair itself
  DriftFinding at_reference_;
};

}  // namespace facenav::monitoring
