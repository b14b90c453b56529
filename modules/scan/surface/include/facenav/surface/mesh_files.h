#pragma once
// Writes meshes for other programs: STL, PLY, OBJ, VTP, GIFTI. Always Mri coordinates (RAS mm,
// resources/doc/formats.md), never LPS. For programs that assume LPS (3D Slicer does for STL without a
// header) the file's comment says "SPACE=RAS".

#include <filesystem>
#include <string>

#include "facenav/core/file_access.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

enum class MeshFormat { stl, ply, obj, vtp, gifti };

/// File name extension of a format, with the dot: ".stl", ".gii".
std::string extensionOf(MeshFormat format);
/// Writes vertices, triangles and, where the format has them, normals; whole file or nothing. Single
/// precision in STL, PLY and GIFTI (0.01 um at 100 mm). Throws Error when the mesh is empty or the file
/// cannot be written.
void writeMesh(const TriangleMesh& mesh, MeshFormat format, const std::filesystem::path& path,
               FileAccess access = FileAccess::owner_only);

}  // namespace facenav::surface
