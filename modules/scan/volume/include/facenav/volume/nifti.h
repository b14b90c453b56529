#pragma once
// Reads and writes NIfTI-1 (through niftiio, the reference implementation). World coordinates are RAS mm:
// from sform if its code is > 0, else from qform. The result contains which one was used and whether the two
// disagree. Lengths in metres or micrometres become mm. If they disagree about left and right or about the
// size of the head, the warning reports it; a case keeps it as a finding that its sign-off must acknowledge.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/file_access.h"
#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Choice between a file's two voxel-to-world maps.
enum class NiftiTransform { automatic, sform, qform };
/// Parses "automatic", "sform", "qform"; throws Error for any other word.
NiftiTransform niftiTransformNamed(const std::string& name);

struct NiftiRead {
  Volume volume;                       // orientation_source is "sform" or "qform"
  std::string evidence;                // in words: which map was used, why, and whether the other one agrees
  std::optional<std::string> warning;  // why the user must check it: sform and qform disagree by more than
                                       // 0.1 mm somewhere in the grid, ..
  bool is_template_space = false;  // the map used leads to MNI, Talairach or another template, by its code
  std::string statistic;           // statistic of a map, by its intent: "t", "z", "F", "r", "p"; else empty
};

/// The file name endings of NIfTI, for window and command line: ".nii", ".nii.gz", and the two files of a
/// pair, ".hdr" and ".img" (either one names the pair).
const std::vector<std::string>& niftiEndings();
/// True for a NIfTI file name, in upper or lower case; the content is not read.
bool isNiftiName(const std::filesystem::path& path);

/// Reads any of niftiEndings(), any scalar type, with scl_slope and scl_inter applied.
/// Throws Error: missing, truncated, not NIfTI, NIfTI-2, not 3-D, colour, no orientation, not rigid up to
/// scale (the other map is offered if it is), impossible units, the requested map is absent.
NiftiRead readNifti(const std::filesystem::path& path, NiftiTransform choice = NiftiTransform::automatic);
Mask readMask(const std::filesystem::path& path);
/// The voxels above 0.5.
Mask maskOf(const Volume& volume);

/// A vector a voxel, as files of coils' fields hold them.
struct NiftiVectors {
  VoxelGrid grid;
  std::vector<Eigen::Vector3f> vectors;  // as in the file; may be no number
  std::string description;               // of the header
};
/// Reads a file of 3 values a voxel (in its 4th or 5th dimension). Throws Error as readNifti does.
NiftiVectors readNiftiVectors(const std::filesystem::path& path);

/// Writes a .nii or .nii.gz completely or not at all: int16 if all values are integers in its range, else
/// uint16 by the same rule, else float32. Sets both sform and qform (code 1) if the grid is orthogonal.
void writeNifti(const Volume& volume, const std::filesystem::path& path,
                FileAccess access = FileAccess::owner_only);
void writeMask(const Mask& mask, const std::filesystem::path& path,
               FileAccess access = FileAccess::owner_only);

}  // namespace facenav::volume
