#pragma once
// DriftCheck: does the face still lie where it is tracked? The face is measured densely in the plain pair
// (its own texture; no dots are needed) and fitted, 6 degrees of freedom, to the MRI's skin at the tracked
// pose. The tracker follows the looks of the skin, this check its shape, so neither shares the other's
// errors: pictures learnt wrong, skin that crept, a head re-found in a wrong place.
// Data flow: StereoFrame + tracked camera_T_mri -> DriftFinding. What the skin misfits the MRI by, and what
// stereo without dots adds, is measured once in the reference pair and taken off.

#include <memory>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/registration/scalp_field.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::monitoring {

struct DriftFinding {
  enum class Verdict { agrees, drifted, unknown };  // unknown: too little of the face could be measured
  Verdict verdict = Verdict::unknown;
  double shift_mm = 0.0,
         turn_deg = 0.0;  // of the face as measured against the face as tracked, at its centre
  double shift_sigma_mm = 0.0, turn_sigma_deg = 0.0;  // their standard errors
  int points = 0;                                     // measured on the face's skin
};

class DriftCheck {
 public:
  /// `reference`: with the surface that was aligned; `camera_T_mri`: the alignment, at that frame.
  DriftCheck(const cameras::StereoRig& rig, std::shared_ptr<const registration::ScalpField> scalp,
             const head_tracking::HeadReference& reference, const RigidTransform<Camera, Mri>& camera_T_mri);

  /// Some 40 ms; const, and safe beside other threads.
  DriftFinding measure(const cameras::StereoFrame& frame,
                       const RigidTransform<Camera, Mri>& camera_T_mri) const;

 private:
  /// The skin of the reference, by the pixels of the left reference image: where the face is face, and how
  /// far it lies outside of the MRI's skin there.
  struct SkinMap {
    int columns = 0, rows = 0;
    std::vector<float> misfit_mm;  // not a number: no skin was aligned there
    std::optional<float> at(const Eigen::Vector2d& reference_px) const;
  };
  struct Offset {
    Vector6d xi = Vector6d::Zero();  // (w rad, v mm) that brings the measured face to the tracked one, Head's
                                     // axes, about the face's centre
    Matrix6d covariance = Matrix6d::Zero();
    int points = 0;
  };
  /// Of one measured point with its counterpart on the skin.
  struct Sample {
    Eigen::Vector3d p_mm;  // Camera
    Eigen::Vector2f left_px;
    double misfit_mm, sigma_mm;
  };

  double depthPerPixel_mm(double depth_mm) const;  // of disparity
  std::vector<Sample> measureSkin(const cameras::StereoFrame& frame, const Eigen::Isometry3d& motion) const;
  std::optional<Offset> offsetOf(const std::vector<Sample>& samples, const Eigen::Isometry3d& motion) const;

  cameras::StereoRig rig_;
  std::shared_ptr<const registration::ScalpField> scalp_;
  Eigen::Isometry3d mri_T_head_;
  std::vector<Eigen::Vector3d> surface_mm_;  // some points of the reference's, Head
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  SkinMap skin_;
  Vector6d bias_ = Vector6d::Zero();  // the offset found in the reference pair itself
};

}  // namespace facenav::monitoring
