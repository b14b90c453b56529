#pragma once
// Reads and writes poses.csv (columns of resources/doc/formats.md): one line per frame and object. `head` is
// camera_T_mri (camera_T_head without an alignment), `coil` is camera_T_coil (camera_T_marker without a coil
// file). Millimetres.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
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
  std::string of_frame = {};              // the pose is camera_T_<this>: mri, head, coil, marker; "": unknown
  std::string detail = {};                // when lost: one word, finer than the reason, for people; "": none

  /// Returns the pose in the frames that the caller gives, or Lost.
  template <class To, class From>
  Tracked<RigidTransform<To, From>> tracked() const {
    if (!pose) return Lost{reason.value_or(LostReason::stale)};
    return {RigidTransform<To, From>::fromIsometry(*pose), quality};
  }
};

/// Word for a frame in the column of_frame (FaceNav's addition to resources/doc/formats.md). It distinguishes
/// a pose of the head since tracking started from a pose of the MRI.
template <class Frame>
constexpr const char* frameWord() {
  if constexpr (std::is_same_v<Frame, Mri>) return "mri";
  if constexpr (std::is_same_v<Frame, Head>) return "head";
  if constexpr (std::is_same_v<Frame, Coil>) return "coil";
  if constexpr (std::is_same_v<Frame, Marker>) return "marker";
  return "";
}

template <class To, class From>
PoseRow poseRow(std::int64_t frame, double t_s, PoseObject object,
                const Tracked<RigidTransform<To, From>>& pose) {
  if (!pose) return {frame, t_s, object, std::nullopt, 0.0, pose.reason(), frameWord<From>(), {}};
  return {frame, t_s, object, pose->isometry(), pose.quality(), std::nullopt, frameWord<From>(), {}};
}

std::string posesCsvHeader();
/// Formats one line with its newline. The decimal point does not depend on the locale.
std::string toCsvLine(const PoseRow& row);
/// Makes header and lines of a second coil's table from those above. It has the coil's name as its last
/// column. Its `coil` rows are the second coil's, its `head` rows those of poses.csv, so that it is read like
/// poses.csv.
std::string secondCoilHeader(const std::string& header);
std::string ofSecondCoil(const std::string& line, const std::string& coil);
/// Path of the second coil's table beside the first one's: poses.csv -> poses_coil2.csv.
std::filesystem::path secondCoilPath(const std::filesystem::path& path);
/// Writes the whole file. Throws Error.
void writePoses(const std::vector<PoseRow>& rows, const std::filesystem::path& path,
                const std::string& second_coil);
/// Writes the whole file. Throws Error.
void writePoses(const std::vector<PoseRow>& rows, const std::filesystem::path& path);
/// Reads poses.csv, with columns in any order; unknown ones are ignored. Throws Error naming file and line: a
/// missing column, a field that is no number, a tracked row without a unit quaternion, an unknown status,
/// object or reason.
std::vector<PoseRow> readPoses(const std::filesystem::path& path);

}  // namespace facenav::casefile
