#pragma once
// TriangleMesh <-> vtkPolyData, for VTK's filters and the .vtp files. Points keep their order, so that arrays
// with one entry per vertex (texture coordinates, scalars) still match.

#include <vtkSmartPointer.h>

#include <filesystem>

#include "facenav/core/file_access.h"
#include "facenav/surface/triangle_mesh.h"

class vtkPolyData;

namespace facenav::surface {

/// Converts points, triangles and, if the mesh has them, point normals (float). Coordinates stay double.
vtkSmartPointer<vtkPolyData> toPolyData(const TriangleMesh& mesh);
/// Converts back. Throws Error for polygons other than triangles. Normals come from the points' "Normals", or
/// else from the faces around each vertex, weighted by area.
TriangleMesh toTriangleMesh(vtkPolyData& poly_data);
/// Adds one float per point under `name`.
void addPointValues(vtkPolyData& poly_data, const char* name, const std::vector<float>& values);
/// Unit normals from the faces around each vertex, weighted by area.
std::vector<Eigen::Vector3d> vertexNormals(const TriangleMesh& mesh);

/// Writes the whole file or nothing, binary appended and compressed. Throws Error.
void writePolyData(vtkPolyData& poly_data, const std::filesystem::path& path,
                   FileAccess access = FileAccess::owner_only);
/// Reads a .vtp file. Throws Error if it is missing or another kind of file.
vtkSmartPointer<vtkPolyData> readPolyData(const std::filesystem::path& path);

}  // namespace facenav::surface
