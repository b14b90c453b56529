#pragma once
// CoilTracker: the coil's pose from its printed marker(s) in both images (paper, section 5). Search:
// binarise, label dark regions, pick quadrangles, match the registered pattern. Then one pose is fitted to
// all printed edges in both images. While the coil is tracked, edges are searched near the predicted pose and
// nothing is binarised.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "facenav/cameras/exposure_offset.h"
#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/frame_work.h"
#include "facenav/core/tracked.h"
#include "facenav/geometry/rotation.h"
#include "facenav/health/verify_rig.h"

namespace facenav::coil_tracking {

struct MarkerModel {
  std::string dictionary = "4x4_50";  // ArUco dictionary; ignored if pattern is set
  int id = 7;
  std::optional<std::filesystem::path> pattern;  // ARToolKit .patt
  double size_mm = 60.0;                         // edge of the black square
  // Standard error of size_mm (measured, or the page's ruler checked). It distinguishes a print of another
  // size from a camera that turned along the epipolar lines. A larger value accepts a wrong print size, and
  // with it a wrong depth.
  double size_sigma_mm = 0.1;
  RigidTransform<Coil, Marker> coil_T_marker;
};

/// coil.json (resources/doc/formats.md).
struct CoilModel {
  std::string name;
  std::vector<MarkerModel> markers;
  std::optional<std::filesystem::path> mesh;  // STL in Coil coordinates, mm
  /// The point touched to nose and ear to check an alignment; by default the contact face's centre.
  Point<Coil> tip;
  RigidTransform<Marker, Coil> marker_T_coil() const { return markers.front().coil_T_marker.inverse(); }
};
/// Throws Error naming file and key.
CoilModel readCoil(const std::filesystem::path& path);
void writeCoil(const CoilModel& coil, const std::filesystem::path& path);
/// One 60 mm marker, dictionary 4x4_50, id 7, marker_T_coil identity. Used without a coil file.
CoilModel defaultCoil();

struct CoilPose {
  RigidTransform<Camera, Marker>
      camera_T_marker;  // of the model's first marker, whichever marker was visible
  Matrix6d covariance = Matrix6d::Zero();
  std::array<Eigen::Vector2d, 4> left_corners_px,
      right_corners_px;  // of the best visible marker, clockwise on the print from top left
};

/// Input of the tracker for a frame besides its images.
struct CoilContext {
  cameras::ExposureOffset exposure_offset;  // of this frame's cameras
  FrameWork work_before;                    // work already done in this frame
  /// Pose of the right camera in this frame; empty: as in the frame before, at first as at start().
  std::optional<RigidTransform<RightCamera, Camera>> right_T_left = {};
  /// Standard error of the right camera's direction, beyond the calibration's, rad, while it moves on its
  /// mount and is followed. Nod and roll of this size are accepted, since both leave the depth unchanged. The
  /// print's size must fit nevertheless.
  double right_turn_sigma_rad = 0.0;
};

/// The pose or Lost, the work done, and observations of the cameras.
struct CoilResult : Tracked<CoilPose> {
  using Tracked<CoilPose>::Tracked;
  CoilResult(Tracked<CoilPose> pose) : Tracked<CoilPose>(std::move(pose)) {}
  FrameWork work;      // total of this frame with earlier work; 0 if not counted
  FrameWork deferred;  // search work beyond this frame's budget, to be reserved in the next frame
  /// The marker in both images, even if its pose was rejected. Empty if no marker was fitted, and while the
  /// coil moves.
  std::optional<health::SquareObservation> observation;
  /// Row times of left and right camera, as used from the next frame on: those of the rig, or those measured
  /// if the coil's motion shows others with certainty.
  std::array<double, 2> row_times_s{0.0, 0.0};
};

class CoilTracker {
 public:
  virtual ~CoilTracker() = default;
  /// Resets the tracker. Throws Error if the coil has no marker or a pattern cannot be read.
  virtual void start(const cameras::StereoRig& rig, const CoilModel& coil) = 0;
  /// Returns Lost{camera} for an unusable frame (no image, another size).
  virtual CoilResult track(const cameras::StereoFrame& frame, const CoilContext& context) = 0;
  CoilResult track(const cameras::StereoFrame& frame) { return track(frame, CoilContext()); }
};

std::unique_ptr<CoilTracker> makeMarkerCoilTracker();  // "marker"

/// The coil's marker as an observation of the cameras, for the check of a rig. `tracker` may be null, which
/// gives an empty finder. Throws Error as CoilTracker::start.
health::SquareFinder squareFinder(std::shared_ptr<CoilTracker> tracker, const cameras::StereoRig& rig,
                                  const CoilModel& coil);

}  // namespace facenav::coil_tracking
