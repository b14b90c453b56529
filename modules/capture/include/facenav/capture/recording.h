#pragma once
// Recording: the folder of FORMATS.md, in and out. Readable with image folders or videos, any start index,
// any rig.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "facenav/capture/frame_source.h"
#include "facenav/core/whole_folder.h"

namespace facenav::capture {

/// The still pairs for the initial alignment; the head has not moved between them.
struct CapturePair {
  cameras::StereoFrame pattern, plain;
};

struct Recording {
  std::filesystem::path folder;
  cameras::StereoRig rig;
  std::optional<CapturePair> capture;  // where capture/ exists
  std::int64_t frame_count = 0;
  double frames_per_s = 60.0;
  bool has_timestamps = false;  // false: 60 fps is assumed (a warning was logged)
};

/// Checks the whole folder before anything runs. Throws Error: no stereo.yml, 0 frames, left and right counts
/// differ, image sizes differ from the rig's, a malformed timestamps.csv line (file and line named), times
/// that do not rise.
Recording openRecording(const std::filesystem::path& folder);
/// A recording that may consist of capture/ alone (for `align`): 0 frames is no error here.
Recording openCapture(const std::filesystem::path& folder);
std::unique_ptr<FrameSource> makeSource(const Recording& recording);

/// frame -> pose, from truth/head.csv or truth/coil.csv (frame,tx,ty,tz,qw,qx,qy,qz).
std::map<std::int64_t, Eigen::Isometry3d> readTruth(const std::filesystem::path& csv);

/// Writes a recording frame by frame into a temporary folder next to `folder`; close() renames it into place,
/// so that a recording is whole or absent. An unclosed writer removes what it wrote.
class RecordingWriter {
 public:
  /// Makes missing parent folders. Pictures of a patient's face: owner_only. Throws Error where `folder`
  /// holds something and `existing` is refuse.
  RecordingWriter(const std::filesystem::path& folder, const cameras::StereoRig& rig,
                  FileAccess access = FileAccess::by_umask, Existing existing = Existing::refuse);
  ~RecordingWriter();
  void add(const cameras::StereoFrame& frame);
  void setCapture(const CapturePair& pair);
  void addTruth(std::int64_t frame, const std::optional<Eigen::Isometry3d>& camera_T_mri,
                const std::optional<Eigen::Isometry3d>& camera_T_marker);
  /// The folder being written (for additional files such as scenario.json).
  const std::filesystem::path& temporaryFolder() const;
  void close();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::capture
