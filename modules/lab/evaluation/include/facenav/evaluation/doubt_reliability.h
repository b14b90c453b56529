#pragma once
// Tests the uncertainty ("doubt") that a brain segmentation gives for points of its surface. A reliability
// table (as for forecasts: Murphy and Winkler 1977) sorts the points into bins of doubt and gives their real
// distance to the true surface. For a calibrated method the error grows from bin to bin and stays below the
// doubt for about the expected share of points.

#include <string>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct DoubtedPlace {
  double doubt_mm = 0, error_mm = 0;  // given by the method; distance to the true surface
};

/// Distance to a mask's surface (the centres of its surface voxels), computed once for the whole grid.
class SurfaceError {
 public:
  explicit SurfaceError(const volume::Mask& reference);
  /// Distance at a point, accurate to the nearest voxel; a point beyond the grid counts as its nearest voxel.
  double at_mm(const Point<Mri>& place) const;

 private:
  volume::VoxelGrid grid_;
  std::vector<float> distance_mm_;
};

struct ReliabilityBin {
  double from_mm = 0, to_mm = 0;  // of doubt: from < doubt <= to; the last one is open
  std::size_t places = 0;
  double share = 0;                            // of all points
  double really = 0;                           // share of all points whose error lies in this bin's range
  double mean_error_mm = 0, p90_error_mm = 0;  // 0 without points
  double wrong = 0;                            // share with an error above kCertain_mm
};

constexpr double kCertain_mm = 2;  // limit for "certain" in a region's confidence

/// Sorts points into bins 0-1, 1-2, 2-3, 3-5, 5-8 and beyond 8 mm (a doubt of 0 is in the first).
std::vector<ReliabilityBin> reliabilityOf(const std::vector<DoubtedPlace>& places);

struct ReliabilityRow {
  std::string volume, method, against;  // "true surface", "unperturbed mask"
  std::vector<ReliabilityBin> bins;
  double stated_certain = 0, really_certain = 0;  // shares of points with doubt / error <= kCertain_mm
  std::string contrast = {};                      // that the method found, in words
};
ReliabilityRow reliabilityRow(std::string volume, std::string method, std::string against,
                              const std::vector<DoubtedPlace>& places);
std::string reliabilityMarkdown(const std::vector<ReliabilityRow>& rows);

/// Pools all points against the true surface: one row per method and contrast, and one per method if it found
/// several. `volume` gives the number of scans. 90 % errors cannot be pooled: 0.
std::vector<ReliabilityRow> pooledReliability(const std::vector<ReliabilityRow>& rows);
/// One line per row and bin: number of points with such a doubt, and number with such an error.
std::string doubtBandsMarkdown(const std::vector<ReliabilityRow>& rows);

}  // namespace facenav::evaluation
