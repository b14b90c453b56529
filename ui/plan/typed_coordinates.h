#pragma once
// Reads three typed coordinates in mm, with a point or a comma as the decimal mark. Refuses ambiguous input.

#include <Eigen/Core>
#include <QString>
#include <optional>

namespace facenav::ui {

struct TypedCoordinates {
  std::optional<Eigen::Vector3d> mm;
  QString fault;  // why the text cannot be read, in one line
};

/// Numbers are separated by spaces, by ';', or by ',' next to a space: "-38 5 60", "12,5; -3,0; 40", "12.5,
/// -3.0, 40", "12,5 -3 40". A comma between two digits is a decimal mark, except if such commas are the only
/// separators of three numbers: "-38,5,60". Refused: a number with both marks, decimal points beside decimal
/// commas, "12,5,-3,0,40", "12,5 40".
TypedCoordinates readCoordinates(const QString& typed);

/// Reads one typed number: "-38.5", "+45", "12,5", with or without its unit. Returns nothing for other text.
std::optional<double> readNumber(const QString& typed, const QString& unit);

}  // namespace facenav::ui
