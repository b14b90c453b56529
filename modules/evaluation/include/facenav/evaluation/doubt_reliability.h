#pragma once
// Does the doubt that a brain segmentation states about places of its surface tell where it is wrong? A
// reliability table (as for forecasts: Murphy and Winkler 1977): places in bins of stated doubt, beside the
// real distance to the true surface. In a calibrated method the error grows from bin to bin and stays below
// the doubt at about the stated share of places.

#include <string>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct DoubtedPlace {
  double doubt_mm = 0, error_mm = 0;  // stated; to the nearest place of the true surface
};

/// Distance to a mask's surface (the centres of its surface voxels), worked out once.
class SurfaceError {
 public:
  explicit SurfaceError(const volume::Mask& reference);
  /// To the nearest voxel's precision; a place beyond the grid counts as its nearest voxel.
  double at_mm(const Point<Mri>& place) const;

 private:
  volume::VoxelGrid grid_;
  std::vector<float> distance_mm_;
};

struct ReliabilityBin {
  double from_mm = 0, to_mm = 0;  // of doubt: from < doubt <= to; the last one is open
  std::size_t places = 0;
  double share = 0;                            // of all places
  double mean_error_mm = 0, p90_error_mm = 0;  // 0 without places
  double wrong = 0;                            // share further than kCertain_mm off
};

constexpr double kCertain_mm = 2;  // what a region's confidence counts as certain

/// Bins 0-1, 1-2, 2-3, 3-5, 5-8 and beyond 8 mm (a doubt of 0 is in the first).
std::vector<ReliabilityBin> reliabilityOf(const std::vector<DoubtedPlace>& places);

struct ReliabilityRow {
  std::string volume, method, against;  // "true surface", "unperturbed mask"
  std::vector<ReliabilityBin> bins;
  double stated_certain = 0, really_certain = 0;  // share of places: doubt, error at most kCertain_mm
};
ReliabilityRow reliabilityRow(std::string volume, std::string method, std::string against,
                              const std::vector<DoubtedPlace>& places);
std::string reliabilityMarkdown(const std::vector<ReliabilityRow>& rows);

}  // namespace facenav::evaluation
