#pragma once
// RigStore: camera pairs stored under a name: which two cameras, with which locked settings and which
// calibration. One folder a rig: rig.json (resources/doc/formats.md) and stereo.yml. Default place: the
// user's configuration folder.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/capture/camera_backend.h"
#include "facenav/capture/camera_pair_source.h"
#include "facenav/core/whole_folder.h"

namespace facenav::capture {

/// One of the rig's cameras.
struct RigCamera {
  CameraIdentity identity;
  CameraSettings settings;  // with the locked values of the adjustments
};

/// Effect of the calibration's error at the target: one standard deviation.
struct RigUncertainty_mm {
  double distance_mm = 0;  // distance of the target from the left camera
  double point_mm = 0;     // error of a point's position
};

/// Stored result of one check.
struct RigCheckNote {
  std::string utc;    // ISO 8601
  std::string state;  // "holds", "moved", ..
  std::string words;
};

/// Row times of a rolling shutter as measured by a session: the time from one row to the row below, s.
struct MeasuredRowTimes {
  std::string utc;  // ISO 8601
  double left_s = 0, right_s = 0;
};

struct NamedRig {
  std::string name, created_utc;
  std::optional<RigCamera> left, right;  // both or none: a rig made from files alone has no cameras
  cameras::StereoRig rig;
  std::optional<RigUncertainty_mm> uncertainty;
  std::optional<RigCheckNote> last_check;
  std::optional<MeasuredRowTimes> row_times;  // in `rig` they replace the calibration's own
};

/// A folder of the store; `problem`: the reason why it cannot be read.
struct RigEntry {
  std::string name;
  std::filesystem::path folder;
  std::optional<NamedRig> rig;
  std::string problem;
};

class RigStore {
 public:
  /// Opens a store. The folder need not exist yet. Empty: $XDG_CONFIG_HOME/facenav/rigs, else
  /// ~/.config/facenav/rigs.
  explicit RigStore(std::filesystem::path folder = {});
  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path folderOf(const std::string& name) const;
  /// Entries sorted by name.
  std::vector<RigEntry> list() const;
  /// Reads a rig. Throws Error: there is no such rig (the message lists the existing ones), or a file of it
  /// is damaged.
  NamedRig read(const std::string& name) const;
  /// Writes the whole folder or nothing. Throws Error: the name has characters other than letters, digits,
  /// blank, '-', '_' and '.', or it is taken and `existing` is refuse. Measured row times of a replaced rig
  /// stay if cameras, their formats and the picture size are the same.
  void write(const NamedRig& rig, Existing existing) const;
  /// Replaces the note of the last check. Throws Error as read().
  void note(const std::string& name, const RigCheckNote& check) const;
  /// Replaces the measured row times; they are in read().rig from then on. Throws Error as read().
  void noteRowTimes(const std::string& name, const MeasuredRowTimes& row_times) const;

 private:
  std::filesystem::path folder_;
};

/// Opens the rig's two cameras with its settings. Throws CameraError, naming the camera: not connected,
/// another piece of the same model, in use; Error if the rig has no cameras.
std::unique_ptr<CameraPairSource> openRig(const CameraBackends& backends, const NamedRig& rig);
/// Adjustments that differ from the rig's, one line each: "left camera, exposure: 5 ms was asked for, ..".
std::vector<std::string> changedSettings(const CameraPairSource& source);
/// Adjustments that differed from the rig's when the cameras were opened, and were restored, one line each:
/// "left camera, exposure: was 20 ms, is 8 ms again".
std::vector<std::string> restoredSettings(const CameraPairSource& source);

/// Note of a check at this moment.
RigCheckNote noteOfNow(const std::string& state, const std::string& words);

}  // namespace facenav::capture
