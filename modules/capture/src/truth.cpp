#include <cmath>

#include "csv_table.h"
#include "facenav/capture/recording.h"
#include "facenav/core/error.h"

namespace facenav::capture {

std::map<std::int64_t, Eigen::Isometry3d> readTruth(const std::filesystem::path& csv) {
  const NumericTable table = readColumns(csv, {"frame", "tx", "ty", "tz", "qw", "qx", "qy", "qz"});
  std::map<std::int64_t, Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& v = table.rows[i];
    const Eigen::Quaterniond q(v[4], v[5], v[6], v[7]);
    if (std::abs(q.norm() - 1) > 1e-3)
      throw Error("quaternion is not of unit length", atLine(csv, table.lines[i]));
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = q.normalized().toRotationMatrix();
    pose.translation() = Eigen::Vector3d(v[1], v[2], v[3]);
    if (v[0] != std::floor(v[0])) throw Error("frame is no whole number", atLine(csv, table.lines[i]));
    poses[std::int64_t(v[0])] = pose;
  }
  return poses;
}

}  // namespace facenav::capture
