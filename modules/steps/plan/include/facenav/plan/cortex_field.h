#pragma once
// The field of a planned pose on the cortex of a case: its strength at the target, its maximum, the
// comparison with an imported field, and the output that gives a target the field of another one. The region
// that it reaches is in field_region.h. Fields in V/m at a rate of the current of 1 A/us unless stated;
// places in Mri. See resources/doc/field.md for what the numbers mean.

#include "facenav/efield/coil_dipoles.h"
#include "facenav/plan/head_field.h"

namespace facenav::steps {

/// Outward normal of the cortex at a target, mean over the vertices within 3 mm of the nearest one. On the
/// bank of a sulcus it points across the sulcus.
struct CortexNormal {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double off_radial_deg = 0;  ///< angle to the direction out of the head under the coil; small on a crown
};
CortexNormal cortexNormal(const FieldSurfaces& surfaces, const guidance::Target& target);

struct FieldOnCortex {
  Eigen::Matrix3Xd field;  ///< at the cortex' vertices
  Eigen::Vector3d at_target = Eigen::Vector3d::Zero();
  CortexNormal normal;
  double along_normal = 0;  ///< > 0: out of the cortex; no number where the model has no directions
  double peak = 0;
  Point<Mri> peak_place;
  double peak_distance_mm = 0;  ///< from the target's cortex point
};
FieldOnCortex fieldOnCortex(const HeadField& head, const FieldSurfaces& surfaces,
                            const efield::CoilDipoles& coil, const guidance::Target& target);

/// |E| in the brain mask, 0 elsewhere, on the mask's grid. Throws Error if the case has no
/// brain mask.
volume::Volume fieldVolume(const HeadField& head, const FieldSurfaces& surfaces,
                           const efield::CoilDipoles& coil, const CoilPose& mri_T_coil, double rate_A_per_us);
/// Writes the field at a rate of the current to .vtp, .msh (vectors on the cortex) or .nii, .nii.gz (|E| in
/// the brain). Throws Error for another name.
void writeField(const HeadField& head, const FieldSurfaces& surfaces, const efield::CoilDipoles& coil,
                const guidance::Target& target, double rate_A_per_us, const std::filesystem::path& path);
/// True for a name that writeField writes.
bool isFieldName(const std::filesystem::path& path);

struct FieldComparison {
  int points = 0;
  bool is_scaled = false;     ///< the other field's rate is unknown: compared after the best scaling
  double scale = 1;           ///< other field over this one, by least squares
  double relative_error = 0;  ///< |this - other| / |other|, of vectors, or of magnitudes if the other file
                              ///< has no vectors
  double peak_ratio = 1;      ///< this maximum over the other one, after scaling
  double peak_shift_mm = 0;   ///< distance between both maxima
};
/// Compares two models of one head on its cortex, for a planned pose.
FieldComparison compareModels(const HeadField& head, const HeadField& other, const FieldSurfaces& surfaces,
                              const efield::CoilDipoles& coil, const guidance::Target& target);
/// Compares with a field of another program's file (imported_field.h), or a .vtp file, on the same cortex.
/// `rate_A_per_us`: that of the imported field; `surface`: of values on a surface, its GIFTI file. Throws
/// Error if its points do not lie on this cortex (half of them within 5 mm).
FieldComparison compareField(const HeadField& head, const FieldSurfaces& surfaces,
                             const efield::CoilDipoles& coil, const guidance::Target& target,
                             const std::filesystem::path& file, std::optional<double> rate_A_per_us,
                             const std::filesystem::path& surface = {});

/// Output that gives the target the strength that the hotspot had at the motor threshold, % of the maximal
/// output; may exceed 100. Both with the same coil. For information; nothing is set.
double doseByField_pct(double hotspot_at_unit_rate, double target_at_unit_rate, double threshold_pct);

}  // namespace facenav::steps
