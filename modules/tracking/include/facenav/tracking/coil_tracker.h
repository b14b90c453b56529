#pragma once
// CoilTracker: the coil's printed marker(s) in both images (paper, section 5): binarise, label dark regions, pick
// quadrangles, match the registered pattern, refine the corners, one pose from both images.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/tracked.h"
#include "facenav/geometry/rotation.h"
#include "facenav/stereo/stereo_frame.h"
#include "facenav/stereo/stereo_rig.h"

namespace facenav::tracking {

struct MarkerModel {
  std::string dictionary = "4x4_50";                    // ArUco dictionary; ignored where pattern is set
  int id = 7;
  std::optional<std::filesystem::path> pattern;         // ARToolKit .patt
  double size_mm = 60.0;                                // edge of the black square
  RigidTransform<Coil, Marker> coil_T_marker;
};

/// coil.json (FORMATS.md).
struct CoilModel {
  std::string name;
  std::vector<MarkerModel> markers;
  std::optional<std::filesystem::path> mesh;            // STL in Coil coordinates, mm
  RigidTransform<Marker, Coil> marker_T_coil() const { return markers.front().coil_T_marker.inverse(); }
};
/// Throws Error naming file and key.
CoilModel readCoil(const std::filesystem::path& path);
void writeCoil(const CoilModel& coil, const std::filesystem::path& path);
/// One 60 mm marker, dictionary 4x4_50, id 7, marker_T_coil identity: used where no coil file was given.
CoilModel defaultCoil();

struct CoilPose {
  RigidTransform<Camera, Marker> camera_T_marker;       // of the first marker of the model, whichever was seen
  Matrix6d covariance = Matrix6d::Zero();
  std::array<Eigen::Vector2d, 4> left_corners_px, right_corners_px;  // of the best seen marker, from top-left clockwise on the print
};

class CoilTracker {
 public:
  virtual ~CoilTracker() = default;
  virtual void start(const stereo::StereoRig& rig, const CoilModel& coil) = 0;
  virtual Tracked<CoilPose> track(const stereo::StereoFrame& frame) = 0;
};

std::unique_ptr<CoilTracker> makeMarkerCoilTracker();   // "marker"

}  // namespace facenav::tracking
