#pragma once
// SessionTrack: head, coil and guidance frame by frame, from poses.csv and guidance.csv of a session or of
// `facenav track` and `guide`. Compact: some 100 bytes a frame, so that hours fit into memory. A torn or
// damaged line is left out and counted. Gaps are not filled: a frame without a pose is lost.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/geometry/rigid_transform.h"

namespace facenav::casefile {

/// Values of a line of guidance.csv, with the names used there.
struct TrackGuidance {
  float distance_mm = 0, lateral_mm = 0, depth_mm = 0, tilt_deg = 0, twist_deg = 0, beam_miss_mm = 0,
        predicted_error_mm = 0;
};

struct TrackMoment {
  std::int64_t frame = 0;
  double t_s = 0;
  /// A pose in single precision (1e-4 mm).
  struct Pose {
    float t_mm[3] = {0, 0, 0}, q_wxyz[4] = {1, 0, 0, 0};
  };
  Pose head, coil;
  TrackGuidance guidance;
  bool has_head = false, has_coil = false, has_guidance = false;
  // Indices into SessionTrack::words: why head or coil is lost; target and state of the guidance. 0: no word.
  std::uint16_t head_reason = 0, coil_reason = 0, target = 0, state = 0;

  std::optional<RigidTransform<Camera, Mri>> camera_T_mri() const;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil() const;
};

struct SessionTrack {
  std::vector<TrackMoment> moments;  // by time
  std::vector<std::string> words{""};
  std::vector<std::string> problems;
  bool is_in_mri = true;  // false: tracked without a case, so the head's poses are not those of the MRI
  bool is_coil = true;    // false: tracked without a coil file, so they are those of the marker

  const std::string& word(std::uint16_t index) const { return words[index]; }
  double duration_s() const { return moments.empty() ? 0.0 : moments.back().t_s - moments.front().t_s; }
  /// Index of the last moment at or before `t_s` (0 if all are later). Requires a track with moments.
  std::size_t at(double t_s) const;
};

/// Reads a track; `guidance_csv` may be missing. Throws Error: no poses.csv, or one without the columns of
/// resources/doc/formats.md.
SessionTrack readSessionTrack(const std::filesystem::path& poses_csv,
                              const std::filesystem::path& guidance_csv);

}  // namespace facenav::casefile
