#pragma once
// RunRecord: the measurements of one run of the live path over one sequence, with the truth. `facenav
// evaluate` fills it from the virtual room or from a recording with truth; all other results are computed
// from it. Poses map into Camera, millimetres.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace facenav::evaluation {

/// Truth of one frame.
struct FrameTruth {
  std::string label;                                    // the event, in words
  std::optional<Eigen::Isometry3d> head;                // camera_T_mri; nullopt: the patient is absent
  std::optional<Eigen::Isometry3d> marker;              // camera_T_marker; nullopt: no coil in the room
  bool must_be_lost = false;                            // the images do not allow a head pose
  double face_visible_fraction = 1.0;                   // share of the face's skin that both cameras see
  double camera_turn_deg = 0.0, camera_shift_mm = 0.0;  // motion of the right camera on its mount since the
                                                        // capture
};

struct FrameRecord {
  std::int64_t frame = 0;
  double t_s = 0.0;
  FrameTruth truth;
  std::optional<Eigen::Isometry3d> head_motion;  // camera_T_head as tracked; nullopt when lost
  std::optional<Eigen::Isometry3d> marker;       // camera_T_marker as tracked
  bool is_marker_in_view = false;                // by the truth: whole square inside both images
  bool is_camera_noticed = false;                // reported that a camera moved: corrected, or every pose
                                                 // lost
  double head_ms = 0.0, coil_ms = 0.0;           // processor time, one core
};

struct AlignmentRecord {
  std::string refusal;  // the program's reason for no alignment; empty if there is one
  Eigen::Isometry3d estimated = Eigen::Isometry3d::Identity(), truth = Eigen::Isometry3d::Identity();
  double predicted_mm = 0.0;       // standard error at the cortical target, as shown to the user
  double bound95_mm = 0.0;         // 95 % of true errors should be below it
  double rms_mm = 0.0;             // surface residual
  std::optional<double> turn_deg;  // rotation of the right camera, estimated from the face's size
  double turn_sigma_deg = 0.0;     // its standard error
  /// Error of a coil on the target, measured with the same cameras, relative to the head as shown, and the
  /// values given for it. Empty if not tried.
  std::optional<double> coil_mm;
  double coil_bound95_mm = 0.0;
  bool is_coil_withheld = false;  // its pose is withheld: the marker does not have its size
  double fit_ms = 0.0,
         measure_ms = 0.0;  // processor time of the fit, and of the face measurement before it
};

/// The face cloud compared with the exact depth (cloud_evaluation.h).
struct CloudFigures {
  static constexpr std::array<double, 5> kLags_mm{8, 16, 32, 64, 110};
  int points = 0;
  double rms_mm = 0.0;        // along the ray, points on the visible face, without gross errors
  double predicted_mm = 0.0;  // rms of the deviation that the matcher gives for these points
  double gross_percent = 0;   // of those points: share with an error above 2 mm
  double coverage_percent = 0;
  // Errors along the ray: the mean over the face, and the mean product of the means of two 8 mm patches whose
  // distance lies between two neighbours of kLags_mm (the error that neighbours share).
  double mean_mm = 0.0;
  std::array<double, 4> shared_mm2{};
};

struct RunRecord {
  std::string scenario, head, rig;
  std::string from;              // plain_align: input of the alignment
  bool must_be_refused = false;  // another person's scan, moved cameras, a mirrored scan
  std::uint64_t seed = 0;
  bool is_scan_cut = false;                             // the scan ends above the chin
  bool is_unseen_head = false;                          // held out: not used in development
  std::string failure;                                  // why the run failed; empty if it did not
  Eigen::Vector3d target_mm = Eigen::Vector3d::Zero();  // cortical target, Mri
  Eigen::Isometry3d marker_T_coil = Eigen::Isometry3d::Identity();
  bool is_capture_repeated = false;  // cloud and alignment are those of an earlier run with the same images
  std::optional<CloudFigures> cloud;
  std::optional<AlignmentRecord> alignment;
  Eigen::Isometry3d true_reference =
      Eigen::Isometry3d::Identity();  // camera_T_mri at the trackers' reference
  double frames_per_s = 60.0;
  std::vector<FrameRecord> frames;
};

}  // namespace facenav::evaluation
