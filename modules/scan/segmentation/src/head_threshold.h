#pragma once
// The threshold between air and tissue, for T1 MR of any scale and offset and for CT in Hounsfield units.

#include <string>
#include <vector>

namespace facenav::segmentation {

struct HeadThreshold {
  bool is_ct = false;
  double air = 0.0, air_sigma = 0.0;  // level of the air and its spread
  double tissue = 0.0;                // median level of the bright class
  double value = 0.0;                 // values above are tissue
};

/// Finds the threshold. `values`: block means of about 2 mm; `modality` as in volume::Volume. Throws Error
/// for a volume with one single value ("no head in this volume").
HeadThreshold findHeadThreshold(std::vector<float> values, const std::string& modality);

}  // namespace facenav::segmentation
