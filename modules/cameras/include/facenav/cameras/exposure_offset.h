#pragma once
// ExposureOffset: how much later than the left camera the right one exposes. Ordinary cameras run free.

namespace facenav::cameras {

struct ExposureOffset {
  double right_late_s = 0.0;  // 0 while it is not known to differ from 0
  double sigma_s = 0.0;       // 0: not measured
};

}  // namespace facenav::cameras
