#pragma once
// Recording: the folder of resources/doc/formats.md, read and written. It may contain image folders or
// videos, any start index, any rig.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "facenav/capture/frame_source.h"
#include "facenav/core/whole_folder.h"

namespace facenav::capture {

/// The still pairs for the initial alignment; the head does not move between them. Without a projector,
/// `pattern` is the plain pair again.
struct CapturePair {
  cameras::StereoFrame pattern, plain;
};

struct Recording {
  std::filesystem::path folder;
  cameras::StereoRig rig;
  std::optional<CapturePair> capture;  // if capture/ exists
  std::int64_t frame_count = 0;
  double frames_per_s = 60.0;
  bool has_timestamps = false;  // false: 60 fps is assumed (a warning is logged)
};

/// Checks the whole folder before any processing. Throws Error: no stereo.yml, 0 frames, left and right
/// counts differ, image sizes differ from the rig's, a malformed timestamps.csv line (file and line named),
/// times that do not increase.
Recording openRecording(const std::filesystem::path& folder);
/// Like openRecording, but a recording with capture/ alone (for `align`) is valid: 0 frames is no error.
Recording openCapture(const std::filesystem::path& folder);
std::unique_ptr<FrameSource> makeSource(const Recording& recording);

/// Truth pose of each frame, from truth/head.csv or truth/coil.csv (frame,tx,ty,tz,qw,qx,qy,qz).
std::map<std::int64_t, Eigen::Isometry3d> readTruth(const std::filesystem::path& csv);

/// Writes a recording frame by frame into a temporary folder next to `folder`. close() renames the folder to
/// its final name, so that a recording is complete or absent. Without close(), the destructor removes what
/// was written.
class RecordingWriter {
 public:
  /// Creates missing parent folders. Use owner_only for pictures of a patient's face. Throws Error if
  /// `folder` is not empty and `existing` is refuse.
  RecordingWriter(const std::filesystem::path& folder, const cameras::StereoRig& rig,
                  FileAccess access = FileAccess::owner_only, Existing existing = Existing::refuse);
  ~RecordingWriter();
  void add(const cameras::StereoFrame& frame);
  /// Sets the capture. An empty `pattern`: there is no projector; only the plain pair is written.
  void setCapture(const CapturePair& pair);
  void addTruth(std::int64_t frame, const std::optional<Eigen::Isometry3d>& camera_T_mri,
                const std::optional<Eigen::Isometry3d>& camera_T_marker,
                const std::optional<Eigen::Isometry3d>& camera_T_second_marker = {});
  /// The temporary folder (for additional files such as scenario.json).
  const std::filesystem::path& temporaryFolder() const;
  void close();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::capture
