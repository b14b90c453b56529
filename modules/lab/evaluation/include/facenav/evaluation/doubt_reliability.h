#pragma once
// Tests the uncertainty ("doubt") that a brain segmentation states for points of its surface. A reliability
// table (as for forecasts: Murphy and Winkler 1977) sorts the points into bins of stated doubt and gives
// their real distance to the true surface. For a calibrated method the error grows from bin to bin and stays
// below the doubt for about the stated share of points.

#include <string>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct DoubtedPlace {
  double doubt_mm = 0, error_mm = 0;  // stated; distance to the true surface
};

/// Distance to a mask's surface (the centres of its surface voxels), computed once for the whole grid.
class SurfaceError {
 public:
  explicit SurfaceError(const volume::Mask& reference);
  /// Accurate to the nearest voxel; a point beyond the grid counts as its nearest voxel.
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

/// Bins 0-1, 1-2, 2-3, 3-5, 5-8 and beyond 8 mm (a doubt of 0 is in the first).
std::vector<ReliabilityBin> reliabilityOf(const std::vector<DoubtedPlace>& places);

struct ReliabilityRow {
  std::string volume, method, against;  // "true surface", "unperturbed mask"
  std::vector<ReliabilityBin> bins;
  double stated_certain = 0, really_certain = 0;  // shares of points with doubt / error <= kCertain_mm
  std::string contrast = {};                      // that the method saw, in words
};
ReliabilityRow reliabilityRow(std::string volume, std::string method, std::string against,
                              const std::vector<DoubtedPlace>& places);
std::string reliabilityMarkdown(const std::vector<ReliabilityRow>& rows);

/// All points against the true surface together: one row per method and contrast seen, and one per method
/// where it saw several. `volume` tells how many scans. The 90 % errors cannot be put together: 0.
std::vector<ReliabilityRow> pooledReliability(const std::vector<ReliabilityRow>& rows);
/// One line per row and bin: how many points are stated there, and how many errors lie there.
std::string doubtBandsMarkdown(const std::vector<ReliabilityRow>& rows);

}  // namespace facenav::evaluation
