#pragma once
// RunRecord: what one run of the live path over one sequence measured, beside what was really there. Filled
// by `facenav evaluate` from the virtual room or from a recording with truth; everything else is computed
// from it. Poses map into Camera, millimetres.

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace facenav::evaluation {

/// What is really there in one frame.
struct FrameTruth {
  std::string label;                        // what happens, in words
  std::optional<Eigen::Isometry3d> head;    // camera_T_mri; nothing: the patient is not there
  std::optional<Eigen::Isometry3d> marker;  // camera_T_marker; nothing: no coil in the room
  bool must_be_lost = false;                // no honest tracker can give the head's pose
  double face_visible_fraction = 1.0;       // of the face's skin, seen by both cameras
};

struct FrameRecord {
  std::int64_t frame = 0;
  double t_s = 0.0;
  FrameTruth truth;
  std::optional<Eigen::Isometry3d> head_motion;  // camera_T_head as tracked; nothing when lost
  std::optional<Eigen::Isometry3d> marker;       // camera_T_marker as tracked
  bool is_marker_in_view = false;                // whole square inside both images, by the truth
  double head_ms = 0.0, coil_ms = 0.0;           // processor time, one core
};

struct AlignmentRecord {
  std::string refusal;  // why there is none, in the program's words; empty: there is one
  Eigen::Isometry3d estimated = Eigen::Isometry3d::Identity(), truth = Eigen::Isometry3d::Identity();
  double predicted_mm = 0.0;  // standard error at the cortical target, as shown to the clinician
  double bound95_mm = 0.0;    // below which 95 % of true errors should lie
  double rms_mm = 0.0;        // surface residual
  double fit_ms = 0.0,
         measure_ms = 0.0;  // processor time of the fit, and of the face's measurement before it
};

/// The face cloud against the exact depth (cloud_evaluation.h).
struct CloudFigures {
  int points = 0;
  double rms_mm = 0.0;       // along the ray, points on the visible face, gross ones left out
  double predicted_mm = 0.0;  // rms of the deviation that the matcher states for these points
  double gross_percent = 0;  // of those points, off by more than 2 mm
  double coverage_percent = 0;
};

struct RunRecord {
  std::string scenario, head, rig;
  std::uint64_t seed = 0;
  bool is_scan_cut = false;                             // the scan ends above the chin
  bool is_unseen_head = false;                          // not the patient that the project is developed on
  std::string failure;                                  // the run could not be made: why
  Eigen::Vector3d target_mm = Eigen::Vector3d::Zero();  // cortical target, Mri
  Eigen::Isometry3d marker_T_coil = Eigen::Isometry3d::Identity();
  bool is_capture_repeated = false;  // cloud and alignment are an earlier run's: the same images
  std::optional<CloudFigures> cloud;
  std::optional<AlignmentRecord> alignment;
  Eigen::Isometry3d true_reference =
      Eigen::Isometry3d::Identity();  // camera_T_mri at the trackers' reference
  double frames_per_s = 60.0;
  std::vector<FrameRecord> frames;
};

}  // namespace facenav::evaluation
