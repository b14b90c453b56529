#pragma once
// poses.csv in and out (columns of FORMATS.md): one line per frame and object. `head` is camera_T_mri
// (camera_T_head without an alignment), `coil` is camera_T_coil (camera_T_marker without a coil file);
// millimetres.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/tracked.h"
#include "facenav/geometry/rigid_transform.h"

namespace facenav::casefile {

enum class PoseObject { head, coil };

struct PoseRow {
  std::int64_t frame = 0;
  double t_s = 0.0;
  PoseObject object = PoseObject::head;
  std::optional<Eigen::Isometry3d> pose;  // absent when lost
  double quality = 0.0;                   // 0..1
  std::optional<LostReason> reason;       // when lost

  /// The pose with the frames that the reader knows it has, or Lost.
  template <class To, class From>
  Tracked<RigidTransform<To, From>> tracked() const {
    if (!pose) return Lost{reason.value_or(LostReason::stale)};
    return {RigidTransform<To, From>::fromIsometry(*pose), quality};
  }
};

template <class To, class From>
PoseRow poseRow(std::int64_t frame, double t_s, PoseObject object,
                const Tracked<RigidTransform<To, From>>& pose) {
  if (!pose) return {frame, t_s, object, std::nullopt, 0.0, pose.reason()};
  return {frame, t_s, object, pose->isometry(), pose.quality(), std::nullopt};
}

std::string posesCsvHeader();
/// One line, newline included; decimals do not depend on the locale.
std::string toCsvLine(const PoseRow& row);
/// A whole file. Throws Error.
void writePoses(const std::vector<PoseRow>& rows, const std::filesystem::path& path);
/// Columns in any order, unknown ones ignored. Throws Error naming file and line: a column missing, a field
/// that is no number, a tracked row without a unit quaternion, an unknown status, object or reason.
std::vector<PoseRow> readPoses(const std::filesystem::path& path);

}  // namespace facenav::casefile
