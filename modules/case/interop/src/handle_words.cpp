#include "handle_words.h"

namespace facenav::interop {
namespace {

constexpr double kCounts = 0.38;  // sine of 22.5 degrees: eight directions share the circle

}  // namespace

std::string directionInWords(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d d = direction.normalized();
  std::string along, beside, words;
  if (std::abs(d.y()) > kCounts) along = d.y() > 0 ? "front" : "back";
  if (std::abs(d.x()) > kCounts) beside = d.x() > 0 ? "right" : "left";
  if (!along.empty() || !beside.empty())
    words = "to the " + along + (along.empty() || beside.empty() ? "" : " and ") + beside + " of the head";
  if (std::abs(d.z()) <= kCounts) return words;
  return words + (words.empty() ? "" : ", ") + (d.z() > 0 ? "upwards" : "downwards");
}

std::string handleQuestion(const Eigen::Vector3d& y) {
  return "as written its handle points " + directionInWords(-y) + ", flipped " + directionInWords(y) +
         ": give --y-sign as-written or --y-sign flipped";
}

}  // namespace facenav::interop
