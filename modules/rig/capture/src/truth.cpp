#include <array>
#include <cmath>

#include "facenav/capture/recording.h"
#include "facenav/core/csv_table.h"
#include "recording_frames.h"

namespace facenav::capture {

std::map<std::int64_t, Eigen::Isometry3d> readTruth(const std::filesystem::path& csv) {
  const CsvTable table(csv, kTypedByHand);
  std::array<std::size_t, 8> columns{};
  for (std::size_t c = 0; c < columns.size(); ++c)
    columns[c] = table.column(std::array{"frame", "tx", "ty", "tz", "qw", "qx", "qy", "qz"}[c]);
  std::map<std::int64_t, Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    std::array<double, 8> v{};
    for (std::size_t c = 0; c < columns.size(); ++c) v[c] = table.number(i, columns[c]);
    const Eigen::Quaterniond q(v[4], v[5], v[6], v[7]);
    if (std::abs(q.norm() - 1) > 1e-3) table.refuse(i, "quaternion is not of unit length");
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = q.normalized().toRotationMatrix();
    pose.translation() = Eigen::Vector3d(v[1], v[2], v[3]);
    if (v[0] != std::floor(v[0])) table.refuse(i, "frame is no whole number");
    poses[std::int64_t(v[0])] = pose;
  }
  return poses;
}

}  // namespace facenav::capture
