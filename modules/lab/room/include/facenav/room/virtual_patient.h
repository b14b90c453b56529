#pragma once
// VirtualPatient: a head made from an MRI: its skin as a closed mesh, a photographic face placed by
// landmarks, and hair 2-5 mm above the MRI's skin. It is the ground truth of the patient for scenarios and
// tests.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "facenav/core/field.h"
#include "facenav/core/task_monitor.h"
#include "facenav/geometry/rigid_transform.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::room {

class SkinTexture;

struct PatientOptions {
  bool has_hair = true;
  double hair_thinnest_mm = 2.0, hair_thickest_mm = 5.0;
  double skin_contrast = 1.0, skin_brightness = 1.0;
  std::uint64_t seed = 1;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(Field{"has_hair", "hair on the scalp"}, self.has_hair);
    visitor(Field{"hair_thinnest_mm", "hair stands at least this far proud of the skin", 0, 20},
            self.hair_thinnest_mm);
    visitor(Field{"hair_thickest_mm", "and at most this far", 0, 30}, self.hair_thickest_mm);
    visitor(Field{"skin_contrast", "scales blotches, freckles and pores: 0.3 a smooth young skin", 0, 3},
            self.skin_contrast);
    visitor(Field{"skin_brightness", "scales the skin's albedo: 0.35 dark, 1.3 pale", 0.1, 1.8},
            self.skin_brightness);
    visitor(Field{"seed", "of hair and skin"}, self.seed);
  }
};

struct VirtualPatient {
  surface::TriangleMesh skin;     // Mri: the true air/skin boundary
  surface::TriangleMesh visible;  // the same triangles, raised by the hair
  std::vector<float> hair;        // 0..1, one per vertex
  std::vector<float> tone;        // blotches and freckles: factor on the albedo, one per vertex
  float pore_contrast = 0.06f;    // standard deviation of the pores' grain, relative to the albedo
  float skin_brightness = 1.f;    // factor on the skin's albedo
  double others_contrast = 1.0;   // contrast of blotches and freckles of persons derived from this one
  std::shared_ptr<const SkinTexture> texture;
  std::vector<Eigen::Vector3d>
      landmarks68_mm;      // iBUG 68 points on the skin, Mri; empty if the scan has no face
  Point<Mri> head_centre;  // centre of the brain case: pivot of head motion
  Point<Mri> face_middle;  // between eyes and mouth, on the skin
};

/// Builds the patient from a T1. Throws Error if it contains no head or the portrait is not installed.
VirtualPatient makePatient(const volume::Volume& mri, const PatientOptions& options, TaskMonitor& monitor);
/// Builds the patient from a skin mesh (a case's scalp surface). Throws as above.
VirtualPatient makePatient(const surface::TriangleMesh& skin, const PatientOptions& options,
                           TaskMonitor& monitor);

/// Returns the head with the contrast of its blotches, freckles and pores scaled; also for persons derived
/// from it.
VirtualPatient withSkinContrast(const VirtualPatient& patient, double contrast);

/// Coil pose over the hand area of the left motor cortex, estimated from the head's outline alone: tangent to
/// the skin, raised by `gap_mm` (hair), handle 45 degrees to posterior-lateral. For scenarios without a
/// planned target.
RigidTransform<Mri, frames::Target> leftHandArea(const VirtualPatient& patient, double gap_mm = 5.0);

}  // namespace facenav::room
