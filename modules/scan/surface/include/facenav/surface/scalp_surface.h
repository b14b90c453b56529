#pragma once
// ScalpSurface: the air/skin boundary of the MRI (paper, section 3). It is only the outermost surface,
// without inner cavities, placed with sub-voxel accuracy at the steepest point of the outer edge. Half of the
// bright fat's maximum would lie 0.5-1.5 mm too deep.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::surface {

/// Standard error of skin that ends in dark air; alignment and plan include it anyway.
constexpr double kClearSkin_mm = 0.15;

/// Accuracy of a face that cameras measured in place of a scan's skin. Standard errors; all but the first are
/// common to its points.
struct FaceMeasurement {
  int points = 0;       // measured points in the surface
  double point_mm = 0;  // median over the points, along the view
  double sight_mm = 0;  // along the view, common to neighbours
  double whole_mm = 0;  // along the view, common to the whole face
  /// Relative error of its size: a camera that turned sideways since the calibration measures every length
  /// too long or too short. nullopt: nothing showed whether a camera had turned.
  std::optional<double> size = {};
};

struct ScalpSurface {
  TriangleMesh mesh;
  /// Standard error of the skin along its normal, per vertex: larger beneath pads and haze. Empty: unknown
  /// (cases made before it was measured).
  std::vector<float> doubt_mm = {};
  /// Planes that bound the scan (a point on each, normal out of the scan), Mri. Skin is cut where it meets
  /// them.
  std::vector<std::pair<Point<Mri>, Direction<Mri>>> field_of_view;
  bool has_face = false;              // nose, brow and eye sockets are there to align to
  bool has_cut_ear = false;           // the last of `findings` describes it; it does not concern the face
  std::vector<std::string> findings;  // plain words: "nose tip cut by the scan's edge"
  /// nullopt: the skin of a scan (or a face that was measured before this was stored).
  std::optional<FaceMeasurement> measurement = {};
};

ScalpSurface extractScalp(const volume::Volume& volume, const volume::Mask& head, TaskMonitor& monitor);
/// Writes scalp.vtp: points, normals, mesh (Mri), point data doubt_mm; has_face, has_cut_ear, findings, field
/// of view and measurement as field data. Whole file or nothing.
void writeScalp(const ScalpSurface& scalp, const std::filesystem::path& path);
ScalpSurface readScalp(const std::filesystem::path& path);
/// The result of writing and reading, bit for bit: normals in single precision, those of the planes
/// normalised again.
ScalpSurface asStored(ScalpSurface scalp);

/// Uncertainty of the skin beneath a coil, mm: within `reach_mm` of a place, as far as it exceeds that of
/// clear skin (root mean square). 0 if unknown.
double skinDoubtUnder_mm(const ScalpSurface& scalp, const Point<Mri>& place, double reach_mm = 20.0);

}  // namespace facenav::surface
