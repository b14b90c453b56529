#pragma once
// ShellMesh: a closed triangle surface between two tissues of the head (Mri, mm), and HeadModel: the nested
// surfaces that the field solver takes. Triangles are counter-clockwise seen from outside.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace facenav::efield {

struct ShellMesh {
  Eigen::Matrix3Xd vertices_mm;
  Eigen::Matrix3Xi triangles;
};

/// Unit sphere from an icosahedron divided `divisions` times: 642 vertices for 3, 2562 for 4. The vertices of
/// a coarser sphere come first. `upper_scale` < 1 makes triangles smaller towards +z and larger towards -z by
/// a conformal map, so that they keep their shape: 0.75 gives edges of 0.75 the length at the top.
ShellMesh icosphere(int divisions, double upper_scale = 1.0);
/// Unit sphere from an icosahedron whose edges are cut into `parts` pieces: 10 parts^2 + 2 vertices. Graded
/// as icosphere().
ShellMesh geodesicSphere(int parts, double upper_scale = 1.0);

/// Area vectors of each vertex, mm^2: a third of the sum over its triangles (outward).
Eigen::Matrix3Xd vertexAreas_mm2(const ShellMesh& mesh);
/// Mean length of the edges at each vertex, mm.
Eigen::VectorXd vertexEdges_mm(const ShellMesh& mesh);
/// Volume within, mm^3; negative if the triangles face inwards.
double volumeWithin_mm3(const ShellMesh& mesh);
/// Throws Error that names the surface unless it is closed and faces outwards.
void requireClosed(const ShellMesh& mesh, const std::string& name);

/// Surfaces of the head, each inside the one before.
struct HeadModel {
  ShellMesh scalp, outer_skull, inner_skull;
  /// Surface of the brain within the fluid; absent: brain and fluid are one compartment.
  std::optional<ShellMesh> brain = {};
};

/// Conductivities in S/m: the values usual for three shells, and that of the fluid (Baumann 1997).
struct Conductivities {
  double scalp = 0.33, skull = 0.33 / 50, brain = 0.33, fluid = 1.79;
};

}  // namespace facenav::efield
