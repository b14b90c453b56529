#include "facenav/segmentation/brain_norms.h"

#include <cmath>

namespace facenav::segmentation {
namespace {

std::string whole(double ml) { return std::to_string(std::lround(ml)); }

}  // namespace

bool isNormalBrain(double volume_ml) {
  return volume_ml >= kNormalBrainLeast_ml && volume_ml <= kNormalBrainMost_ml;
}

std::optional<std::string> brainVolumeFinding(double volume_ml) {
  if (isNormalBrain(volume_ml)) return std::nullopt;
  return "the brain measures " + whole(volume_ml) + " ml, adults have " + whole(kNormalBrainLeast_ml) +
         " to " + whole(kNormalBrainMost_ml) + " ml: check its outline";
}

}  // namespace facenav::segmentation
