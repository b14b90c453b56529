#pragma once
// Services: the steps that the window runs on worker threads, bound to the modules that the command line
// calls too. The program provides the methods (methods/registrations.h); a test replaces single functions.
// They throw Error.

#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/align/alignment_seen.h"
#include "facenav/atlas/brain_template.h"
#include "facenav/capture/camera_backend.h"
#include "facenav/capture/recording.h"
#include "facenav/capture/rig_store.h"
#include "facenav/casefile/case_store.h"
#include "facenav/dicom/series.h"
#include "facenav/dicom/thumbnail.h"
#include "facenav/methods/registrations.h"
#include "facenav/pacs/pacs.h"
#include "facenav/session/session.h"
#include "facenav/setup/cameras_learnt.h"
#include "facenav/setup/rig_setup.h"
#include "facenav/setup/verified_cameras.h"

namespace facenav::ui {

struct PrepareOrder {
  std::filesystem::path input, case_folder;
  std::optional<std::string> series_uid;
  bool is_labelled_by_patient = false;
};

/// Two cameras that are used for the first time, locked at settings that suit the light.
struct NewCameras {
  std::unique_ptr<capture::FrameSource> source;
  capture::RigCamera left, right;
};

/// How a kept rig is verified when its cameras open (setup/verified_cameras.h).
struct RigVerifying {
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
  steps::VerifiedCameras::Told told = {};  // empty: it is not verified
};

/// What is known of a head that is aligned, besides its pictures.
struct HeadKnown {
  const coil_tracking::CoilModel* coil = nullptr;  // whose marker the pictures may show; null: the case's
  bool is_patient_confirmed = false;               // as in steps::AlignOrder
};

struct Services {
  std::function<std::vector<dicom::SeriesInfo>(const std::filesystem::path&, TaskMonitor&)> listSeries;
  /// A small picture of a series; nothing if the series has no image.
  std::function<std::optional<dicom::Thumbnail>(const dicom::SeriesInfo&)> makeThumbnail;
  /// The patient of a series, in words: "Family, Given, born 1970-01-31, F, ID 4711".
  std::function<std::string(const dicom::SeriesInfo&)> whoseSeries;
  // The hospital's archive: test the connection, list series, fetch one into an empty folder.
  std::function<void(const pacs::PacsNode&)> callArchive;
  std::function<std::vector<pacs::PacsSeries>(const pacs::PacsNode&, const pacs::PacsQuery&, TaskMonitor&)>
      findInArchive;
  std::function<pacs::Received(const pacs::PacsNode&, const pacs::PacsSeries&,
                               const std::filesystem::path& folder, pacs::Retrieval, TaskMonitor&)>
      fetchFromArchive;
  /// Sends a DICOM file, or the files of a folder. Returns how many.
  std::function<int(const pacs::PacsNode&, const std::filesystem::path&, TaskMonitor&)> storeInArchive;
  /// Makes the case folder, or replaces the model of an existing case.
  std::function<void(const PrepareOrder&, TaskMonitor&)> prepareCase;
  /// Builds the electric field's model of a case. Empty: it is not built.
  std::function<void(const std::filesystem::path& case_folder, TaskMonitor&)> buildField;
  /// Aligns from a recording's capture pair, or from the one stored with the case. Stores the result in the
  /// case.
  std::function<steps::AlignmentOutcome(const casefile::CaseStore&, const capture::Recording&,
                                        const HeadKnown&, TaskMonitor&)>
      align;
  /// Makes what a person judges the alignment by. Empty: nothing is shown.
  std::function<steps::AlignmentSeen(const casefile::CaseStore&, const steps::AlignmentOutcome&)>
      seeAlignment;
  /// Connected cameras. Search::quick is fast; Search::everywhere waits for the network.
  std::function<std::vector<capture::FoundCamera>(capture::Search)> listCameras;
  /// A live pair, by stable names (capture/camera.h). Its destructor releases both cameras.
  std::function<std::unique_ptr<capture::FrameSource>(const cameras::StereoRig&, const std::string& left,
                                                      const std::string& right)>
      openCameras;
  /// The rigs kept under a name (`facenav rig new`); fast.
  std::function<std::vector<capture::RigEntry>()> listRigs;
  /// Opens the cameras of such a rig with their locked settings. What is found is stored with the rig.
  std::function<std::unique_ptr<capture::FrameSource>(const capture::NamedRig&, const RigVerifying&)> openRig;
  /// Opens two cameras by stable names, without a calibration, in this size. Takes some seconds.
  std::function<NewCameras(const std::string& left, const std::string& right, int width_px, int height_px)>
      openNewCameras;
  std::function<void(const capture::NamedRig&, Existing)> keepRig;
  /// Stores the result of a kept rig's check.
  std::function<void(const std::string& name, const capture::RigCheckNote&)> noteRig;
  /// Stores what a session learnt about a kept rig; callable from any thread.
  std::function<void(const std::string& name, const steps::CamerasLearnt&)> keepLearnt;
  /// Makes the methods by which the set-up judges pictures.
  std::function<steps::SetupMethods()> makeSetupMethods;
  std::function<std::unique_ptr<session::Navigator>(const session::NavigatorSetup&)> makeNavigator;
  /// Reads the labelled atlas. Throws Error if it is not installed.
  std::function<atlas::BrainTemplate()> readTemplate;
};

/// All services as the programs use them. `makeMethods` is called for each task, because threads must not
/// share methods.
Services servicesWith(std::function<steps::Registrations()> makeMethods);

}  // namespace facenav::ui
