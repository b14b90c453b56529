#pragma once
// HeadOutline: how far the head reaches from its centre in each direction, and from its vertical axis at each
// height. Caps and long hair are laid over it.

#include <opencv2/core.hpp>

#include "facenav/room/virtual_patient.h"

namespace facenav::room {

class HeadOutline {
 public:
  explicit HeadOutline(const VirtualPatient& patient);
  /// Distance from the head's centre in a direction: azimuth from the face's front (+y) towards +x,
  /// elevation; rad, mm.
  double reach_mm(double azimuth, double elevation) const;
  const Eigen::Vector3d& centre_mm() const { return centre_mm_; }
  /// Point in a direction, `off_mm` outside of the outline (Mri).
  Eigen::Vector3d at(double azimuth, double elevation, double off_mm) const;
  /// Distance from the vertical axis at a height above the centre, mm.
  double width_mm(double azimuth, double up_mm) const;

 private:
  Eigen::Vector3d centre_mm_;
  cv::Mat reach_mm_;  // float: rows elevation -pi/2 .. pi/2, columns azimuth -pi .. pi
  cv::Mat width_mm_;  // float: rows height, from kLowest_mm, columns azimuth
};

}  // namespace facenav::room
