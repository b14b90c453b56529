#pragma once
// RoomWall: the wall behind the patient, across Room's z, and what is on it.

#include <Eigen/Core>
#include <vector>

namespace facenav::room {

enum class Pattern { none, stripes, checks, spots };

/// A bright rectangle on the wall, Room x and y, mm.
struct RoomWindow {
  Eigen::Vector2d low_mm, high_mm;
  double radiance = 2.0;  // 1: a white sheet facing the main lamp
};

struct RoomWall {
  double distance_mm = 2300.0;
  Pattern pattern = Pattern::none;
  double pattern_mm = 80.0;       // period
  double pattern_contrast = 0.0;  // half the difference of bright and dark, relative to the mean
  double turn_deg = 0.0;          // of the pattern on the wall
  std::vector<RoomWindow> windows;
};

/// Value of a pattern at a place, -1 (dark) .. 1 (bright); 0 for none.
double patternAt(Pattern pattern, double period_mm, double x_mm, double y_mm);

}  // namespace facenav::room
