#pragma once
// Surfaces of other programs, as VTK reads them: .ply .stl .obj .vtk .vtp. Coordinates are taken as RAS mm;
// if the file contains SPACE=LPS, as 3D Slicer writes it, x and y change their signs.

#include <filesystem>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

/// True for the ending of a mesh's file name, in upper or lower case.
bool isMeshName(const std::filesystem::path& path);
/// True for a .vtk or .vtp file with lines and no surface: tracts. Throws as readMesh does.
bool holdsLines(const std::filesystem::path& path);
/// Reads a mesh. Polygons become triangles; normals are those of the file, else of the faces. Throws Error
/// naming the file: missing, damaged, no triangle, a coordinate that is no number.
TriangleMesh readMesh(const std::filesystem::path& path);

}  // namespace facenav::surface
