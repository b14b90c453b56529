#pragma once
// A surface with a vector at each point in a .vtp file: the electric field on the cortex, for ParaView and
// for comparing with other programs. Coordinates are Mri, mm.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/core/file_access.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

struct VectorSurface {
  TriangleMesh mesh;
  std::vector<Eigen::Vector3f> vectors;  // one a vertex
};

/// Writes the vectors as point data `name` and their lengths as "magn" + name; whole file or nothing. Throws
/// Error.
void writeVectors(const VectorSurface& surface, const std::string& name, const std::filesystem::path& path,
                  FileAccess access = FileAccess::owner_only);
/// Reads such a file; further arrays are ignored. Throws Error if it is missing or damaged, has no array of
/// three components of that name, or a value that is no number.
VectorSurface readVectors(const std::filesystem::path& path, const std::string& name);

}  // namespace facenav::surface
