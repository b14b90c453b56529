#pragma once
// HeadEffect: what a calibration's standard errors mean where the head will be, in mm and degrees.

namespace facenav::cameras {

/// One standard deviation, by the rig's covariance, of what it measures where the boards were held.
struct HeadEffect {
  double distance_mm = 0;                // from the left camera
  double point_mm = 0;                   // a point's place in Camera
  double depth_mm = 0;                   // its distance; the rest turns all points alike
  double length_mm = 0;                  // of 100 mm
  double motion_mm = 0, motion_deg = 0;  // of a face moved by 20 mm and turned by 5 deg
};

}  // namespace facenav::cameras
