#pragma once
// Reads surfaces with values of other programs: a GIFTI surface (.gii), and one value a vertex of it from a
// GIFTI or a FreeSurfer "curv" file. Coordinates are the world's RAS mm, as SimNIBS and FreeSurfer's
// "scanner" space have them.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

/// True if the content is that of a file with one value a vertex: FreeSurfer's curv, or GIFTI without a
/// surface.
bool holdsSurfaceValues(const std::string& content);

/// Reads the values. Throws Error naming the file: missing, damaged, of another kind, more than one value a
/// vertex, or a value that is no number.
std::vector<float> readSurfaceValues(const std::filesystem::path& path);

/// Reads a GIFTI surface. Throws Error naming the file: missing, damaged, no surface, coordinates of a
/// template.
TriangleMesh readGiftiSurface(const std::filesystem::path& path);

}  // namespace facenav::surface
