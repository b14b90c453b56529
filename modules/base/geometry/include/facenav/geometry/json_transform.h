#pragma once
// Rigid transforms and points in JSON (resources/doc/formats.md): 4x4 row-major as 16 numbers, millimetres.

#include <array>
#include <cmath>

#include "facenav/core/json_reader.h"
#include "facenav/geometry/rigid_transform.h"

namespace facenav {
inline namespace geometry {

/// Largest coordinate in a file, mm: nothing of a patient, a room or its cameras lies farther away.
constexpr double kFarthest_mm = 1e5;

/// Reads a rigid transform. Throws Error naming file and key unless the value is 16 numbers that form a rigid
/// motion within kFarthest_mm. A mirrored matrix is refused too.
template <class To, class From>
RigidTransform<To, From> readTransform(const JsonReader& json) {
  const auto values = json.numbers(16);
  const Eigen::Matrix4d matrix =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data());
  if (matrix.cwiseAbs().maxCoeff() > kFarthest_mm) json.refuse("lies farther away than 100 m");
  try {
    return RigidTransform<To, From>::fromMatrix(matrix);
  } catch (const Error& fault) {
    json.refuse(fault.what());
  }
}

template <class Frame>
Point<Frame> readPoint(const JsonReader& json) {
  const auto values = json.numbers(3);
  for (const double value : values)
    if (std::abs(value) > kFarthest_mm) json.refuse("lies farther away than 100 m");
  return Point<Frame>(values[0], values[1], values[2]);
}

template <class To, class From>
std::array<double, 16> rowMajor(const RigidTransform<To, From>& transform) {
  std::array<double, 16> values{};
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data()) = transform.matrix();
  return values;
}

template <class Frame>
std::array<double, 3> rowMajor(const Point<Frame>& point) {
  return {point.mm.x(), point.mm.y(), point.mm.z()};
}

}  // namespace geometry
}  // namespace facenav
