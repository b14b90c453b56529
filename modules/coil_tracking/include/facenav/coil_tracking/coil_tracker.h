#pragma once
// CoilTracker: the coil's printed marker(s) in both images (paper, section 5): binarise, label dark regions,
// pick quadrangles, match the registered pattern; then one pose from all printed edges in both images. While
// tracked, the edges are sought round the predicted pose and nothing is binarised.

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

namespace facenav::coil_tracking {

struct MarkerModel {
  std::string dictionary = "4x4_50";  // ArUco dictionary; ignored where pattern is set
  int id = 7;
  std::optional<std::filesystem::path> pattern;  // ARToolKit .patt
  double size_mm = 60.0;                         // edge of the black square
  // How well that is known (measured, or the page's ruler checked): what tells a camera that turned along the
  // epipolar lines from a print of another size. Larger: a wrong print is tolerated, and so is a wrong depth.
  double size_sigma_mm = 0.1;
  RigidTransform<Coil, Marker> coil_T_marker;
};

/// coil.json (FORMATS.md).
struct CoilModel {
  std::string name;
  std::vector<MarkerModel> markers;
  std::optional<std::filesystem::path> mesh;  // STL in Coil coordinates, mm
  RigidTransform<Marker, Coil> marker_T_coil() const { return markers.front().coil_T_marker.inverse(); }
};
/// Throws Error naming file and key.
CoilModel readCoil(const std::filesystem::path& path);
void writeCoil(const CoilModel& coil, const std::filesystem::path& path);
/// One 60 mm marker, dictionary 4x4_50, id 7, marker_T_coil identity: used where no coil file was given.
CoilModel defaultCoil();

struct CoilPose {
  RigidTransform<Camera, Marker> camera_T_marker;  // of the first marker of the model, whichever was seen
  Matrix6d covariance = Matrix6d::Zero();
  std::array<Eigen::Vector2d, 4> left_corners_px,
      right_corners_px;  // of the best seen marker, from top-left clockwise on the print
};

/// What a frame's marker says of the cameras, whether or not its pose was accepted: the same corners in both
/// images, each image measured freely across the epipolar lines, and the print's true size.
struct MarkerSighting {
  std::array<Eigen::Vector2d, 4> left_px, right_px;
  double sigma_px = 0.0;        // of a corner across the epipolar lines
  double size_mm = 0.0;         // edge of the square as given in the model,
  double print_sigma_mm = 0.0;  // how well it is known there
  double size_sigma_mm = 0.0;   // of the size that both images show
};

/// What the session knows when a frame's turn comes.
struct CoilContext {
  cameras::ExposureOffset exposure_offset;  // of this frame's cameras
  FrameWork work_before;                    // what the frame has cost already
};

/// The pose, or Lost, with what the frame has told besides.
struct CoilResult : Tracked<CoilPose> {
  using Tracked<CoilPose>::Tracked;
  CoilResult(Tracked<CoilPose> pose) : Tracked<CoilPose>(std::move(pose)) {}
  FrameWork work;      // of this frame, with what came before; 0 where the method does not count
  FrameWork deferred;  // search that this frame's budget did not allow: room to be kept in the next frame
  std::optional<MarkerSighting> sighting;  // none where no marker was fitted, or while the coil moves
};

class CoilTracker {
 public:
  virtual ~CoilTracker() = default;
  /// Begins anew. Throws Error where the coil has no marker or a pattern cannot be read.
  virtual void start(const cameras::StereoRig& rig, const CoilModel& coil) = 0;
  /// A frame that cannot be used (no image, another size) is Lost{camera}.
  virtual CoilResult track(const cameras::StereoFrame& frame, const CoilContext& context) = 0;
  CoilResult track(const cameras::StereoFrame& frame) { return track(frame, CoilContext()); }
};

std::unique_ptr<CoilTracker> makeMarkerCoilTracker();  // "marker"

}  // namespace facenav::coil_tracking
