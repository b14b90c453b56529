#include "commands/picture_size.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "wrong_usage.h"

namespace facenav::app {

cameras::StereoRig sizeOnly(const std::string& size) {
  constexpr double kMost_px = 100000;
  const auto cross = std::min(size.find('x'), size.size());
  const auto width = numberIn(size.substr(0, cross));
  const auto height = numberIn(size.substr(std::min(cross + 1, size.size())));
  const auto isLength = [](const std::optional<double>& px) {
    return px && *px >= 1 && *px <= kMost_px && *px == std::floor(*px);
  };
  if (!isLength(width) || !isLength(height))
    throw WrongUsage("'" + size + "' is no picture size", "give width and height, as in --size 1280x720");
  cameras::StereoRig rig;
  rig.width_px = int(*width);
  rig.height_px = int(*height);
  return rig;
}

}  // namespace facenav::app
