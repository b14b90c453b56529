#pragma once
// Made files of other programs for a head about the origin: positions of SimNIBS, and pulses as a table.

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"

namespace facenav::testing {

/// A line of SimNIBS's positions: the coil `out_mm` from the origin in that direction, its axis to the
/// origin.
inline std::string coilPosition(const std::string& name, const Eigen::Vector3d& direction,
                                double out_mm = 92) {
  const Eigen::Vector3d z = -direction.normalized();
  const Eigen::Vector3d y = (Eigen::Vector3d::UnitY() - z.y() * z).normalized();
  const Eigen::Vector3d at = -out_mm * z;
  return formatted("CoilPos,%.6f,%.6f,%.6f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,0,", at.x(), at.y(), at.z(), z.x(),
                   z.y(), z.z(), y.x(), y.y(), y.z()) +
         name + "\n";
}

/// Pulses of two sessions without a time, two and one, all over the vertex.
inline std::string twoSessionsOfPulses() {
  std::string text = "kind,name,tx,ty,tz,qw,qx,qy,qz,utc,session,target\n";
  for (const char* session : {"first", "first", "second"})
    text += std::string("pulse,,0,0,92,0,1,0,0,,") + session + ",\n";
  return text;
}

inline std::filesystem::path writtenFile(const std::filesystem::path& file, const std::string& content) {
  writeWholeFile(file, content);
  return file;
}

}  // namespace facenav::testing
