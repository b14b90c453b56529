#pragma once
// BrainPair: template and patient at one spacing, as the registration compares them. The template is on a
// grid in MNI space, cropped to its brain. The patient is sampled onto that grid through the current map.

#include "facenav/atlas/brain_template.h"
#include "scalar_field.h"

namespace facenav::atlas {

/// Two channels: (T1 - local mean) / local deviation, both taken inside the brain (0 outside), and the mask
/// smoothed to 0..1.
struct Channels {
  ScalarField t1, brain;
};
constexpr float kBrainWeight = 1.0f;  // of the mask channel, relative to the T1 channel (unit deviation)

/// Template and patient, band-limited to the finest spacing. Computed once for all levels.
struct BrainImages {
  /// `brain`: the patient's mask. Any grid for all volumes. Throws Error for an empty brain.
  BrainImages(const volume::Volume& template_brain, const volume::Volume& mri, const volume::Mask& brain,
              double finest_mm);

  Eigen::AlignedBox3d template_box_mm, patient_box_mm;  // extent of each brain in its own world
  volume::Volume template_t1, template_brain, patient_t1, patient_brain;
};

class BrainPair {
 public:
  /// Samples both at `spacing_mm`: the images' spacing or a coarser one; the images are smoothed to it first.
  BrainPair(const BrainImages& images, double spacing_mm);

  const volume::VoxelGrid& grid() const { return grid_; }  // world = MNI space
  const Channels& fixed() const { return fixed_; }
  /// The patient at mri_from_mni * (node + displacement), displacement in nodes (null or empty: none).
  Channels warped(const Eigen::Affine3d& mri_from_mni, const VectorField* displacement) const;
  /// dice(): overlap of both brains. correlation(): that of the T1 channels at nodes inside both brains.
  double dice(const Channels& moving) const;
  double correlation(const Channels& moving) const;
  /// Centre and standard deviation along R, A, S of both brains, mm.
  struct Moments {
    Eigen::Vector3d centre_mm, deviation_mm;
  };
  Moments templateMoments() const { return template_moments_; }
  Moments patientMoments() const { return patient_moments_; }

 private:
  volume::VoxelGrid grid_, patient_grid_;
  ScalarField patient_t1_, patient_brain_;
  Channels fixed_;
  Moments template_moments_, patient_moments_;
};

}  // namespace facenav::atlas
