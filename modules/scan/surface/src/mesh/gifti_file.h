#pragma once
// GIFTI (gifti_io, public domain): one surface as a pointset and a triangle array, coordinates in the
// scanner's RAS mm.

#include <filesystem>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

/// Writes directly to `path` (callers write to a temporary file). Returns false when the library could not
/// write it.
bool writeGifti(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace facenav::surface
