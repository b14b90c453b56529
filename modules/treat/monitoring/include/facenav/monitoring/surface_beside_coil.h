#pragma once
// SurfaceBesideCoil: measures how high the live surface (skin or hair) lies above the MRI's skin, by dense
// stereo in the plain pair in a band around the coil's plate. It verifies the gap computed from both poses:
// the poses share the alignment's error, this measurement does not. Data flow: StereoFrame + camera_T_mri +
// camera_T_coil -> BesideCoilFinding. BesideCoilWatch measures about once a second, on its own thread, and
// never delays a frame.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/later_answer.h"
#include "facenav/monitoring/drift_watchdog.h"
#include "facenav/registration/scalp_field.h"

namespace facenav::monitoring {

struct BesideCoilFinding {
  bool has_measured = false;
  double above_skin_mm = 0;  // median height; > 0: outside the MRI's skin
  double sigma_mm = 0;       // its standard error
  int points = 0;
  std::string unseen;  // why nothing was measured: "no skin beside the coil faces both cameras"
};

class SurfaceBesideCoil {
 public:
  /// Builds the measurement. `outline_mm`: the contact face's closed outline in Coil x and y.
  SurfaceBesideCoil(const cameras::StereoRig& rig, std::shared_ptr<const registration::ScalpField> scalp,
                    std::vector<Eigen::Vector2d> outline_mm);

  /// Measures a frame in 0.1 to 0.3 s. Const, and safe to call beside other threads.
  BesideCoilFinding measure(const cameras::StereoFrame& frame,
                            const RigidTransform<Camera, Mri>& camera_T_mri,
                            const RigidTransform<Camera, Coil>& camera_T_coil) const;

  // Band around the plate in which the surface is measured, and its largest height above the MRI's skin.
  static constexpr double kNearest_mm = 5, kFarthest_mm = 45, kReach_mm = 14;

 private:
  struct Band {
    std::vector<Eigen::Vector3d> skin_mm;  // Camera
    cv::Rect box;                          // in the left picture
    double nearest_mm = 0, farthest_mm = 0;
  };
  bool isBeside(const Eigen::Vector3d& p_coil_mm) const;
  bool isInBoth(const Eigen::Vector3d& p_camera_mm) const;
  Band bandOf(const RigidTransform<Camera, Mri>& camera_T_mri,
              const RigidTransform<Camera, Coil>& camera_T_coil) const;

  cameras::StereoRig rig_;
  std::shared_ptr<const registration::ScalpField> scalp_;
  std::vector<Eigen::Vector2d> outline_mm_;
  std::vector<std::size_t> sample_;  // sampled points of the scalp, some millimetres apart
};

/// Measures while head and coil are tracked; its finding is valid while the coil stays about where it was.
class BesideCoilWatch {
 public:
  struct Question {
    std::shared_ptr<const cameras::StereoFrame> frame;
    RigidTransform<Camera, Mri> camera_T_mri;
    RigidTransform<Camera, Coil> camera_T_coil;
  };
  using Measure = std::function<BesideCoilFinding(const Question&)>;
  struct Answer {
    double captured_s;
    RigidTransform<Mri, Coil> mri_T_coil;
    BesideCoilFinding finding;
  };
  using Checks = LaterAnswer<Question, Answer>;
  using Mode = Checks::Mode;

  static constexpr double kHolds_s = 4.0, kHolds_mm = 10.0;  // limits after which a finding is dropped

  BesideCoilWatch(Measure measure, Mode mode);
  /// Adds a frame with both poses, or with none where one is lost. Call it for each frame.
  void add(std::shared_ptr<const cameras::StereoFrame> frame,
           const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri,
           const std::optional<RigidTransform<Camera, Coil>>& camera_T_coil);
  /// Newest finding that is still valid.
  const std::optional<BesideCoilFinding>& finding() const { return shown_; }

 private:
  Checks checks_;
  std::optional<double> asked_s_;
  std::optional<Answer> answer_;
  std::optional<BesideCoilFinding> shown_;
};

}  // namespace facenav::monitoring
