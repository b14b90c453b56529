#pragma once
// RayScene: rigid (and deformable) triangle meshes for ray casting (Embree 3). World = Camera, mm. Embree
// works in float; the hit point is recomputed in double from the triangle's corners, so depth is exact to
// ~1e-4 mm.

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::room {

/// Result of a ray, small enough to store one per pixel.
struct Sight {
  int object = -1;  // -1: nothing
  int triangle = -1;
  float u = 0.f, v = 0.f;  // barycentric: p = (1 - u - v) a + u b + v c
  float distance = 0.f;    // along the ray, in units of its direction's length
};

struct Hit {
  int object = -1;
  int triangle = -1;
  float u = 0.f, v = 0.f;        // barycentric: p = (1 - u - v) a + u b + v c
  double distance = 0.0;         // along the ray, in units of its direction's length
  Eigen::Vector3d p_object_mm;   // on the triangle, in the object's own frame
  Eigen::Vector3d facet_normal;  // unit, world
  Eigen::Vector3d normal;        // unit, world, interpolated between the vertices
};

class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Adds a copy of the mesh. Returns the number of the new object.
  int add(const surface::TriangleMesh& mesh);
  void setPose(int object, const Eigen::Isometry3d& world_T_object);
  const Eigen::Isometry3d& pose(int object) const;
  void setShown(int object, bool is_shown);
  bool isShown(int object) const;
  /// Sets vertex positions and normals of a deforming object; the triangles stay the same.
  void setVertices(int object, const std::vector<Eigen::Vector3d>& vertices_mm,
                   const std::vector<Eigen::Vector3d>& normals);
  const surface::TriangleMesh& mesh(int object) const;
  /// Bounding box of the object in its own frame.
  const Eigen::AlignedBox3d& bounds(int object) const;
  /// Must be called after any change above, before rays are cast.
  void commit();

  Sight look(const Eigen::Vector3d& origin_mm, const Eigen::Vector3d& direction) const;
  /// Computes the exact hit of a sight, for the same ray.
  Hit refine(const Sight& sight, const Eigen::Vector3d& origin_mm, const Eigen::Vector3d& direction) const;
  std::optional<Hit> intersect(const Eigen::Vector3d& origin_mm, const Eigen::Vector3d& direction) const;
  /// True if any object lies between the two points (the first 0.5 mm are ignored).
  bool isBlocked(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::room
