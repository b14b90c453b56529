#include "facenav/surface/brain_model.h"
#include <Eigen/Geometry>
#include <cmath>

#include "facenav/core/error.h"
#include "mesh/mesh_polydata.h"
#include "spherical_map.h"

namespace facenav::surface {
namespace {

using Eigen::Vector3d;

/// Builds the vertices ring by ring: the seam at theta = -pi, the bins' centres, then the seam at theta =
/// +pi.
class PhiThetaMesh {
 public:
  explicit PhiThetaMesh(const SphericalMap& map) : map_(map), ring_(map.columns + 2) {}

  BrainModel build() {
    model_.map = map_;
    for (int r = 0; r < map_.rows; ++r) addRing(r);
    triangulateRings();
    addPole(0, 0.0);
    addPole(map_.rows - 1, M_PI);
    turnOutwards();
    model_.mesh.normals = vertexNormals(model_.mesh);
    joinNormals();
    return std::move(model_);
  }

 private:
  double radius(int row, int column) const {
    return map_.radius_mm[std::size_t(row) * map_.columns + column];
  }

  int addVertex(double phi, double theta, double radius_mm) {
    model_.mesh.vertices_mm.push_back(map_.centre.mm + radius_mm * toDirection({phi, theta}).v);
    model_.texture_coordinates.emplace_back(float((theta + M_PI) / (2 * M_PI)), float(1 - phi / M_PI));
    return int(model_.mesh.vertices_mm.size()) - 1;
  }

  void addRing(int row) {
    const double phi = (row + 0.5) * M_PI / map_.rows;
    const double at_seam_mm = 0.5 * (radius(row, 0) + radius(row, map_.columns - 1));
    const int first = addVertex(phi, -M_PI, at_seam_mm);
    for (int c = 0; c < map_.columns; ++c)
      addVertex(phi, -M_PI + (c + 0.5) * 2 * M_PI / map_.columns, radius(row, c));
    const int last = addVertex(phi, M_PI, at_seam_mm);
    model_.mesh.vertices_mm[last] = model_.mesh.vertices_mm[first];
  }

  /// The 2-D Delaunay triangulation of the phi-theta plane, in units of bins. Each ring is shifted slightly
  /// against the one before; otherwise the four corners of a cell would lie on one circle and rounding would
  /// decide. On this lattice the result is known: each cell is cut along its shorter diagonal. vtkDelaunay2D
  /// gives the same triangles (tested), in seconds to minutes on fine grids.
  void triangulateRings() {
    for (int r = 0; r + 1 < map_.rows; ++r)
      for (int c = 0; c + 1 < ring_; ++c) {
        const int here = r * ring_ + c, below = here + ring_;
        model_.mesh.triangles.emplace_back(here, here + 1, below);
        model_.mesh.triangles.emplace_back(here + 1, below + 1, below);
      }
  }

  /// A fan from the ring to the pole. The pole has one copy per triangle, in the middle of its triangle's
  /// theta.
  void addPole(int row, double phi) {
    double mean_mm = 0;
    for (int c = 0; c < map_.columns; ++c) mean_mm += radius(row, c) / map_.columns;
    const Vector3d pole = map_.centre.mm + mean_mm * Vector3d(0, std::cos(phi), 0);
    for (int c = 0; c + 1 < ring_; ++c) {
      const int left = row * ring_ + c, right = left + 1;
      const double u = 0.5 * (model_.texture_coordinates[left].x() + model_.texture_coordinates[right].x());
      const int top = addVertex(phi, (2 * u - 1) * M_PI, mean_mm);
      model_.mesh.vertices_mm[top] = pole;
      model_.mesh.triangles.emplace_back(left, right, top);
    }
  }

  /// All triangles of a star-shaped surface have the same orientation seen from the centre; makes it
  /// counter-clockwise from outside.
  void turnOutwards() {
    for (auto& t : model_.mesh.triangles) {
      const Vector3d a = model_.mesh.vertices_mm[t[0]] - map_.centre.mm,
                     b = model_.mesh.vertices_mm[t[1]] - map_.centre.mm,
                     c = model_.mesh.vertices_mm[t[2]] - map_.centre.mm;
      if (a.dot(b.cross(c)) < 0) std::swap(t[1], t[2]);
    }
  }

  /// Gives all copies of one point the same normal; otherwise seam and poles would be visible under light.
  void joinNormals() {
    auto& normals = model_.mesh.normals;
    for (int r = 0; r < map_.rows; ++r) {
      const int first = r * ring_, last = first + ring_ - 1;
      normals[first] = normals[last] = (normals[first] + normals[last]).normalized();
    }
    const int poles = map_.rows * ring_, fan = ring_ - 1;
    for (int p = 0; p < 2; ++p) {
      Vector3d sum = Vector3d::Zero();
      for (int c = 0; c < fan; ++c) sum += normals[poles + p * fan + c];
      for (int c = 0; c < fan; ++c) normals[poles + p * fan + c] = sum.normalized();
    }
  }

  const SphericalMap& map_;
  const int ring_;  // vertices of one ring
  BrainModel model_;
};

}  // namespace

BrainModel meshOf(const SphericalMap& map) {
  FACENAV_EXPECT(map.radius_mm.size() == std::size_t(map.rows) * map.columns &&
                     map.colour.size() == map.radius_mm.size(),
                 "a map holds one radius and one colour per bin");
  return PhiThetaMesh(map).build();
}

BrainModel buildBrainModel(const volume::Volume& volume, const volume::Mask& brain,
                           const BrainModelOptions& options, TaskMonitor& monitor) {
  const SphericalMap map = mapBrain(volume, brain, options, monitor);
  monitor.report("meshing the brain's surface", 0.95);
  return meshOf(map);
}

}  // namespace facenav::surface
