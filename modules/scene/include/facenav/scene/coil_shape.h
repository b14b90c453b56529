#pragma once
// CoilShape: how the figure-8 coil looks, in Coil coordinates (mm): contact face in the plane z = 0, housing
// at z < 0, handle along -y. Built from code, or read from the coil's STL (coil.json "mesh").

#include <filesystem>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::scene {

struct CoilShapeOptions {
  double wing_outer_radius_mm = 48.0, wing_inner_radius_mm = 24.0;  // windings of a usual 70 mm figure-8 coil
  double thickness_mm = 12.0, handle_length_mm = 110.0;
};

struct CoilShape {
  surface::TriangleMesh body;      // housing and handle, translucent
  surface::TriangleMesh windings;  // the two rings, solid; empty when read from STL
};

CoilShape makeCoilShape(const CoilShapeOptions& options = {});
/// Throws Error naming the file when it is missing or holds no triangles.
CoilShape readCoilShape(const std::filesystem::path& stl);

}  // namespace facenav::scene
