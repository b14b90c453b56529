#pragma once
// The normal volume of an adult's brain, and the one finding that is made of it: preparation puts it into the
// case, the sign-off page shows the same range.

#include <optional>
#include <string>

namespace facenav::segmentation {

// Adults' brain with cerebellum, both sexes.
constexpr double kNormalBrainLeast_ml = 1100, kNormalBrainMost_ml = 1700;

bool isNormalBrain(double volume_ml);
/// "the brain measures 905 ml, adults have 1100 to 1700 ml: check its outline"; nothing for a normal one.
std::optional<std::string> brainVolumeFinding(double volume_ml);

}  // namespace facenav::segmentation
