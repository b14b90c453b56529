#pragma once
// Reads a coil's field from the files that SimNIBS uses: .ccd (text, dipoles, metres), .tcd (JSON: dipoles,
// pieces of wire, or a sampled field, mm) and .nii, .nii.gz (sampled vector potential, T m per ampere). All
// are in FaceNav's Coil frame: +z into the head, +y away from the handle. What comes out are CoilDipoles.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/efield/coil_source.h"

namespace facenav::efield {

/// True for a name that ends as a coil's field does: .ccd, .tcd, .nii, .nii.gz.
bool isCoilFieldName(const std::filesystem::path& path);

/// Reads a coil as its file describes it. Throws Error naming the file and the line or key: missing, damaged,
/// a number that is none, no current at all, or of a size that is no coil's (mm and m exchanged).
CoilSource readCoilSource(const std::filesystem::path& path);

struct FieldCoil {
  CoilDipoles dipoles;        ///< what the fields take
  int dipoles_in_file = 0;    ///< before thinning
  double thinning_error = 0;  ///< relative, of the field; 0: not thinned
  std::vector<std::string> notes;
};

/// A built-in coil ("figure8-70", "round") or a file, thinned (thinned_coil.h). Throws Error as
/// readCoilSource.
FieldCoil fieldCoil(const std::string& name_or_file);

/// Names of the built-in coils.
const std::vector<std::string>& builtInCoils();

}  // namespace facenav::efield
