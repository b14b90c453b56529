#include "commands/picture_size.h"

#include <cstdio>

#include "facenav/core/error.h"

namespace facenav::app {

cameras::StereoRig sizeOnly(const std::string& size) {
  cameras::StereoRig rig;
  if (std::sscanf(size.c_str(), "%dx%d", &rig.width_px, &rig.height_px) != 2 || rig.width_px < 1 ||
      rig.height_px < 1)
    throw Error("this is no picture size", size, "give width and height, as in --size 1280x720");
  return rig;
}

}  // namespace facenav::app
