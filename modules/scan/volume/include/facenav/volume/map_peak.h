#pragma once
// The peak of a statistical map (fMRI) inside a ball: where to aim. World coordinates of the map's own space,
// Mri or MNI, as its header says.

#include "facenav/volume/nifti.h"
#include "facenav/volume/volume.h"

namespace facenav::volume {

enum class PeakOf { highest, lowest };  // lowest: maps of anticorrelation

struct MapPeak {
  Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();  // between voxels: a parabola along each axis
  double value = 0;                                    // of the voxel
  bool is_at_edge = false;  // on the ball's rim: the map goes on rising (or falling) outside
};

/// Values that are not finite are passed over. Throws Error when no voxel centre lies in the ball, or all
/// voxels in it have one value.
MapPeak peakWithin(const Volume& map, const Eigen::Vector3d& centre_mm, double radius_mm, PeakOf wanted);

enum class MapSpace { mni, mri };

/// The space of `map`, read from `file`: the one that is stated, else MNI where the file says that it lies in
/// a template's space. Throws Error where neither tells it, or they contradict each other.
MapSpace spaceOfMap(const NiftiRead& map, std::optional<MapSpace> stated, const std::filesystem::path& file);

}  // namespace facenav::volume
