#pragma once
// ExposureOffset: delay of the right camera's exposure after the left one's. Ordinary cameras run free.

namespace facenav::cameras {

struct ExposureOffset {
  double right_late_s = 0.0;  // 0 unless a difference is known
  double sigma_s = 0.0;       // 0: not measured
};

}  // namespace facenav::cameras
