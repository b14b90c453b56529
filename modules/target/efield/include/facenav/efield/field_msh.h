#pragma once
// Fields in gmsh's format 2.2, as SimNIBS reads and writes it: nodes in mm (the MRI's world), the vector
// field "E" and its magnitude "magnE" ("normE" of SimNIBS 3, "E_magn" on its central surface), V/m, on nodes
// or elements, text or binary.

#include <filesystem>
#include <vector>

#include "facenav/core/file_access.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::efield {

/// Places with the field there.
struct FieldSamples {
  Eigen::Matrix3Xd points_mm;  ///< Mri
  Eigen::Matrix3Xd field;      ///< V/m; empty where the file has the magnitude alone
  Eigen::VectorXd magnitude;   ///< V/m
  Eigen::VectorXd weight;      ///< volume or area that each place stands for; of nodes 1
};

/// A field of a whole head's mesh.
struct HeadFieldSamples {
  FieldSamples grey;                      ///< grey matter: its volume, else its surface, else all
  FieldSamples brain;                     ///< white and grey matter's volume, else `grey`
  bool fills_brain = false;               ///< `brain` is a volume
  std::vector<Eigen::Vector3d> scalp_mm;  ///< nodes of the scalp (tag 1005); empty: the mesh has none
};

/// Writes the surface with its field on the nodes, binary, triangles with SimNIBS's tag of grey matter
/// (1002); whole file or nothing. Throws Error.
void writeFieldMsh(const surface::TriangleMesh& mesh, const Eigen::Matrix3Xd& field,
                   const std::filesystem::path& path, FileAccess access = FileAccess::owner_only);

/// Writes values at places without a surface: nodes with their field, or its magnitude alone. Throws Error.
void writeFieldPointsMsh(const FieldSamples& samples, const std::filesystem::path& path,
                         FileAccess access = FileAccess::owner_only);

/// Reads "E", or else "magnE". On nodes: those of the grey matter's triangles, else all. On elements: at the
/// middles of the grey matter's triangles (tag 1002), else of its tetrahedra (tag 2), else of all elements.
/// Throws Error naming the file and what is missing or damaged; also for a value that is no number.
FieldSamples readFieldMsh(const std::filesystem::path& path);
/// Reads the same with the volume of the brain and the scalp. Throws as readFieldMsh does.
HeadFieldSamples readHeadFieldMsh(const std::filesystem::path& path);

}  // namespace facenav::efield
