#pragma once
// The peak of a statistical map (fMRI) inside a ball, as an aim. World coordinates of the map's own space,
// Mri or MNI, by its header.

#include "facenav/volume/nifti.h"
#include "facenav/volume/volume.h"

namespace facenav::volume {

enum class PeakOf { highest, lowest };  // lowest: maps of anticorrelation

struct MapPeak {
  Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();  // between voxels: a parabola along each axis
  double value = 0;                                    // value of that voxel
  bool is_at_edge = false;  // on the ball's rim: the map rises (or falls) further outside
};

/// Finds the peak within a ball; ignores values that are not finite. Throws Error if no voxel centre lies in
/// the ball, or all voxels in it have one value.
MapPeak peakWithin(const Volume& map, const Eigen::Vector3d& centre_mm, double radius_mm, PeakOf wanted);

enum class MapSpace { mni, mri };

/// Space of `map`, read from `file`: `stated` if given, else MNI if the file refers to a template's space.
/// Throws Error if neither determines it, or they contradict each other.
MapSpace spaceOfMap(const NiftiRead& map, std::optional<MapSpace> stated, const std::filesystem::path& file);

}  // namespace facenav::volume
