#include "facenav/anatomy/brain_norms.h"

#include <cmath>

namespace facenav::anatomy {
namespace {

std::string whole(double ml) { return std::to_string(std::lround(ml)); }

}  // namespace

std::optional<std::string> brainVolumeFinding(double volume_ml) {
  if (kNormalBrain.contains(volume_ml)) return std::nullopt;
  return "the brain measures " + whole(volume_ml) + " ml, adults have " + whole(kNormalBrain.low) + " to " +
         whole(kNormalBrain.high) + " ml: check its outline";
}

}  // namespace facenav::anatomy
