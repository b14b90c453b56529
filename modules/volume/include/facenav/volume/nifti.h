#pragma once
// NIfTI-1 in and out (through niftiio, the reference implementation). World coordinates are RAS mm: sform
// where its code is > 0, else qform; which one was used, and whether the two disagree, is reported. Where
// they disagree about left and right or about the size of the head, the warning says so: a case then carries
// it as a finding that its sign-off must acknowledge.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/file_access.h"
#include "facenav/volume/volume.h"

namespace facenav::volume {

/// Which of a file's two voxel-to-world maps to believe.
enum class NiftiTransform { automatic, sform, qform };
/// "automatic", "sform", "qform"; throws Error for other words.
NiftiTransform niftiTransformNamed(const std::string& name);

struct NiftiRead {
  Volume volume;         // orientation_source is "sform" or "qform"
  std::string evidence;  // in words: which map was taken, why, and whether the other one agrees
  std::optional<std::string>
      warning;  // sform and qform disagree by more than 0.1 mm somewhere in the grid, ..
};

/// What NIfTI files are called, window and command line alike: ".nii", ".nii.gz", and the two halves of a
/// pair, ".hdr" and ".img" (either stands for both).
const std::vector<std::string>& niftiEndings();
/// By its name alone, upper or lower case.
bool isNiftiName(const std::filesystem::path& path);

/// Reads any of niftiEndings(), any scalar type, with scl_slope and scl_inter applied.
/// Throws Error: missing, truncated, not NIfTI, not 3-D, colour, no orientation, not rigid up to scale, the
/// map asked for is absent.
NiftiRead readNifti(const std::filesystem::path& path, NiftiTransform choice = NiftiTransform::automatic);
Mask readMask(const std::filesystem::path& path);

/// Writes a whole .nii or .nii.gz: int16 where all values are integers in its range, uint16 likewise, else
/// float32. sform and qform (code 1) are both set where the grid is orthogonal.
void writeNifti(const Volume& volume, const std::filesystem::path& path,
                FileAccess access = FileAccess::by_umask);
void writeMask(const Mask& mask, const std::filesystem::path& path, FileAccess access = FileAccess::by_umask);

}  // namespace facenav::volume
