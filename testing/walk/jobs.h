#pragma once
// The main jobs of four users, as steps of a robot. All share one patient, prepared once from a DICOM series.

#include <filesystem>

#include "robot.h"
#include "shell/services.h"
#include "support/test_data.h"

namespace facenav::walk {

/// The virtual patient on disk: a DICOM series, the case prepared from it, a recording.
class Patient {
 public:
  Patient();
  /// The DICOM series, one file a slice.
  const std::filesystem::path& series() const { return series_; }
  /// A recording of tiny plain pictures, 50 a second.
  const std::filesystem::path& recording() const { return recording_; }
  /// A recording of the patient at rest in the virtual room, rendered once (4 s of processor time).
  std::filesystem::path roomRecording();
  /// Services of the program; a case is prepared once and copied from then on.
  ui::Services services();
  /// A new cases folder with a copy of the case, signed off, with one target.
  std::filesystem::path casesFolder(const std::string& name);
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  void prepare(const std::filesystem::path& input, TaskMonitor& monitor);
  const testing::TemporaryFolder folder_;
  std::filesystem::path series_, recording_, prepared_;
};

/// Radiographer: reads a DICOM folder, prepares, looks at the findings, corrects one stroke and undoes it,
/// signs off.
void prepareAScan(Patient& patient, const Look& look);
/// Neurologist: sets a target by a click, nudges and turns it, undoes, takes a preset of the right side.
void planTargets(Patient& patient, const Look& look);
/// Clinician: looks at the camera set-up, aligns and treats with a recording, gives pulses, pauses, ends,
/// reads the report. The trackers are those of gui/treat_fixtures.h: the coil stands at the target.
void treat(Patient& patient, const Look& look);
/// Engineer: sets up two cameras in all four steps (place, calibrate, check and keep, coil) before a virtual
/// room.
void setUpCameras(Patient& patient, const Look& look);
/// Clinician: aligns and guides with the program's own methods, on a recording of the virtual room.
void treatInTheRoom(Patient& patient, const Look& look);
/// A person at home: starts, gives a pulse, finishes; the file to send back is on the desktop.
void treatAtHome(Patient& patient, const Look& look);

}  // namespace facenav::walk
