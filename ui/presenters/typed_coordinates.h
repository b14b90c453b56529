#pragma once
// Three coordinates in mm as people type them, with a point or a comma as the decimal mark. What can be read
// in two ways is refused.

#include <Eigen/Core>
#include <QString>
#include <optional>

namespace facenav::ui {

struct TypedCoordinates {
  std::optional<Eigen::Vector3d> mm;
  QString fault;  // why there are none, in one line
};

/// Numbers are parted by blanks, by ';', or by ',' beside a blank: "-38 5 60", "12,5; -3,0; 40", "12.5, -3.0,
/// 40", "12,5 -3 40". A comma between two digits is a decimal mark, unless such commas are all that parts
/// three numbers:
/// "-38,5,60". Refused: a number with both marks, decimal points beside decimal commas, "12,5,-3,0,40", "12,5
/// 40".
TypedCoordinates readCoordinates(const QString& typed);

/// One number as people type it: "-38.5", "+45", "12,5", with or without its unit behind it. Nothing where it
/// is none.
std::optional<double> readNumber(const QString& typed, const QString& unit);

}  // namespace facenav::ui
