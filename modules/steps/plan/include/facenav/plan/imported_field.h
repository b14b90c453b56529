#pragma once
// Tier 3 of the electric field: what another program (SimNIBS) computed for one planned pose, taken into the
// case. It is judged by the case's skin and T1 first, kept with its target, and used for that pose alone.
// Fields of the file in V/m as it states them; places in Mri.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/plan/head_field.h"

namespace facenav::steps {

struct FieldImport {
  std::filesystem::path file;                ///< .msh, NIfTI, or values on a surface
  std::filesystem::path surface = {};        ///< of values on a surface: its GIFTI file
  std::filesystem::path t1 = {};             ///< NIfTI that the other program used; empty: not named
  std::string target;                        ///< name of the target that it was computed for
  std::optional<double> rate_A_per_us = {};  ///< for which it was computed; nothing: 1, SimNIBS's default
};

/// An imported field, without its values.
struct ImportedField {
  std::string target;
  RigidTransform<Mri, frames::Target> mri_T_target;  ///< pose for which it counts
  std::string words;                                 ///< kind of file, and what the checks found
  double rate_A_per_us = 1;
  double peak = 0, percentile_99_9 = 0;  ///< of the file's grey matter, or of the brain in a volume
  Point<Mri> peak_place;
  bool has_directions = false, fills_brain = false;
  std::vector<std::string> notes = {};  ///< cautions: difference of the poses, ..
  std::string utc;                      ///< when it was imported
  std::string file;                     ///< of its values, in the case's folder
};

/// True if the file may hold a field, by its content.
bool isFieldFile(const std::filesystem::path& file);
/// True if the file holds values alone, whose surface is another file.
bool needsSurface(const std::filesystem::path& file);

/// Reads and judges a field, and writes nothing. Throws Error: no such target, no MRI, no field, a mesh whose
/// scalp is not the case's skin, another T1, nothing near the target, or a coil that stood elsewhere.
ImportedField previewField(const casefile::CaseStore& store, const FieldImport& order);
/// Takes it into the case; replaces an earlier one of the target. Throws as previewField does.
ImportedField importField(const casefile::CaseStore& store, const FieldImport& order);

/// All imported fields of the case. Throws Error if their file is damaged.
std::vector<ImportedField> importedFields(const casefile::CaseStore& store);
/// The field of a target, if it was imported for the pose that the target has now.
std::optional<ImportedField> importedField(const casefile::CaseStore& store, const guidance::Target& target);

/// The model that gives the imported field at that pose, for any coil. Throws Error if the target has none.
/// at() throws Error for another pose; it gives 0 farther than 6 mm from all values.
std::unique_ptr<HeadField> importedHead(const casefile::CaseStore& store, const guidance::Target& target);

}  // namespace facenav::steps
