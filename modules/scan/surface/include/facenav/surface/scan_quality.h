#pragma once
// Quality of the skin in the MRI: where the scan's edge cuts the head, noise and ghosts in the air relative
// to the skin's signal, tissue wrapped around to the other side. Values only; navigation_check.h judges them.

#include <array>
#include <string>

#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::surface {

/// One side of the scan's box.
struct ScanSide {
  std::string name;          // "right", "left", "front", "back", "top", "bottom" of the patient
  double cut_area_mm2 = 0;   // area of the head cut on that side
  double wrapped_share = 0;  // fraction of the head's cut on the opposite side that shows up as tissue here
  bool is_wrapped =
      false;  // front and back only: the tissue here is like the cut opposite, or lies within it
};

struct ScanQuality {
  double largest_voxel_mm = 0, smallest_voxel_mm = 0;
  std::array<ScanSide, 6> sides;
  bool is_air_blanked = false;  // the air has one value: the scanner or a program erased it
  bool is_air_signed = false;   // a CT, or an MR whose air is often negative: no ghosts are measured
  double noise = 0;             // standard deviation of the signal, from the air away from head and ghosts
  double skin_step = 0;         // median rise of the signal from air to skin
  double skin_jitter_mm = 0;    // standard deviation of the skin's position due to noise
  bool has_ghost_measure = false;
  double ghost_share = 0;       // ghosts in the air beside the head, relative to the skin's step
  std::string ghost_direction;  // "left-right", "front-back", "up-down"
};

/// Measures the scan. `scalp`: the skin of `head` in `mri`. Takes less than a second.
ScanQuality measureScan(const volume::Volume& mri, const volume::Mask& head, const TriangleMesh& scalp);

}  // namespace facenav::surface
