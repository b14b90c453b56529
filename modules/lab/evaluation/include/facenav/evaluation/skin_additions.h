#pragma once
// Changes that a scanner may add to a head: shading, a bright nose, a faint halo around the skin, and pads,
// earphones or tape that touch it. Each is added to a real or painted scan, so that the skin found with it
// can be compared with the skin found without (`facenav evaluate skin`). Frame Mri, RAS; lengths in mm.

#include <string>
#include <vector>

#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct SkinAddition {
  std::string name;
  double shading = 0;      // smooth gain field: largest |log gain| within the head
  double bright_nose = 0;  // gain at the nose, less 1; it falls off over 30 mm
  double halo = 0;         // signal up to 6 mm outside the skin, as a share of the skin's own
  // Signal of pads, as a share of the skin's own; 0: none. Thin gaps separate them from the skin in places.
  double pad_behind = 0, pads_beside = 0, earphones = 0;
  double tape = 0;  // signal of a strip that sticks to the forehead without a gap
};

/// The additions of the published table: shading, bright nose, two halos, pads, earphones, tape, and all at
/// once.
std::vector<SkinAddition> skinAdditions();

struct AddedScan {
  volume::Volume scan;
  volume::Mask pads;  // voxels that pads, earphones or tape fill
};

/// A scan and its own skin, to which things are added.
class CleanScan {
 public:
  /// `head`: mask on the volume's grid; `skin`: its surface, Mri. Throws Error for an empty mask or mesh.
  CleanScan(const volume::Volume& volume, const volume::Mask& head, const surface::TriangleMesh& skin);

  /// Adds to the scan; deterministic for a seed. A scan whose air was erased (one value) gets no halo: a
  /// program that erases air erases the halo as well.
  AddedScan with(const SkinAddition& addition, unsigned seed) const;
  bool isAirErased() const { return is_air_erased_; }

 private:
  const volume::Volume& volume_;
  const volume::Mask& head_;
  std::vector<float> away_mm_;  // distance from the skin, > 0 outside
  float skin_ = 0;              // signal of the skin
  bool is_air_erased_ = false;
};

}  // namespace facenav::evaluation
