#pragma once
// BrainModel: the phi-theta textured brain (paper, section 6). SphericalMap is the 180 x 180 array of
// equations 6-8. theta is atan2 over the full 360 degrees, because the paper's arccos would fold front onto
// back.

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "facenav/core/field.h"
#include "facenav/core/file_access.h"
#include "facenav/core/task_monitor.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::surface {

/// Angles of a direction from the brain's centre: phi = acos(y / r) in 0..pi, theta = atan2(z, x) in -pi..pi.
/// The paper's x, y, z are Mri's: x right, y anterior, z superior. So the poles lie at the frontal and the
/// occipital pole, where no targets are planned. Vertex and both hand areas lie near the equator, where bins
/// are largest and most even. The seam (theta = +-pi) runs along the left temporal lobe.
struct SphericalAngles {
  double phi_rad, theta_rad;
};

/// Bin (row, column) is centred on phi = (row + 1/2) pi / rows, theta = -pi + (column + 1/2) 2 pi / columns.
struct SphericalMap {
  int rows = 180, columns = 180;  // phi x theta
  Point<Mri> centre;
  std::vector<double> radius_mm;     // rows x columns: the surface in that direction
  std::vector<std::uint8_t> colour;  // rows x columns: grey value of the outermost brain voxel of the bin
};

SphericalAngles toAngles(const Point<Mri>& p, const Point<Mri>& centre);
/// The unit direction of a pair of angles; the inverse of toAngles().
Direction<Mri> toDirection(const SphericalAngles& angles);

struct BrainModel {
  SphericalMap map;
  /// Closed mesh. The vertices of seam and poles have several copies at identical positions, each with its
  /// own texture coordinate.
  TriangleMesh mesh;
  /// Texture coordinate per vertex, 0..1, origin bottom-left as in VTK: u = (theta + pi) / 2 pi, v = 1 - phi
  /// / pi, so that the map's row 0 is the image's top row.
  std::vector<Eigen::Vector2f> texture_coordinates;
};

struct BrainModelOptions {
  int rows = 180, columns = 180;
  double peel_mm = 5.0;  // depth below the surface over which the texture is averaged

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(Field{"rows", "bins from the front to the back of the brain", 16, 2048}, self.rows);
    visitor(Field{"columns", "bins around the brain's long axis", 16, 2048}, self.columns);
    visitor(Field{"peel_mm", "how deep below the surface the texture looks (0: the outermost voxel)", 0, 40},
            self.peel_mm);
  }
};

/// Builds the model. `brain`: a mask on any grid. Throws Error for an empty mask and for options out of
/// range.
BrainModel buildBrainModel(const volume::Volume& volume, const volume::Mask& brain,
                           const BrainModelOptions& options, TaskMonitor& monitor);
/// The mesh of a map: 2-D Delaunay triangulation in the phi-theta plane, closed at seam and poles.
BrainModel meshOf(const SphericalMap& map);
/// Writes brain.vtp and brain_texture.png beside it, each whole or not at all.
void writeBrain(const BrainModel& brain, const std::filesystem::path& vtp,
                const std::filesystem::path& texture_png, FileAccess access = FileAccess::owner_only);
/// Reads both files. Throws Error if a file is missing, damaged, or the two do not belong together.
BrainModel readBrain(const std::filesystem::path& vtp, const std::filesystem::path& texture_png);

}  // namespace facenav::surface
