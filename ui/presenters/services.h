#pragma once
// Services: the steps that the window asks for, as functions handed in by app/gui_main (the only place that
// names implementations). They run on worker threads, throw Error, and are the same code as the command
// line's verbs.

#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/atlas/brain_template.h"
#include "facenav/capture/camera_list.h"
#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/dicom/series.h"
#include "facenav/dicom/thumbnail.h"
#include "facenav/pacs/pacs.h"
#include "facenav/session/session.h"
#include "facenav/surface/detailed_cortex.h"
#include "facenav/workflow/align_from_capture.h"

namespace facenav::ui {

struct PrepareOrder {
  std::filesystem::path input, case_folder;
  std::optional<std::string> series_uid;
  bool is_labelled_by_patient = false;
};

struct Services {
  std::function<std::vector<dicom::SeriesInfo>(const std::filesystem::path&, TaskMonitor&)> listSeries;
  /// A small picture of a series; nothing where it holds none.
  std::function<std::optional<dicom::Thumbnail>(const dicom::SeriesInfo&)> makeThumbnail;
  /// Whose a series is, in words: "Family, Given, born 1970-01-31, F, ID 4711".
  std::function<std::string(const dicom::SeriesInfo&)> whoseSeries;
  // The hospital's archive: is it there, which series, fetch one into an empty folder.
  std::function<void(const pacs::PacsNode&)> callArchive;
  std::function<std::vector<pacs::PacsSeries>(const pacs::PacsNode&, const pacs::PacsQuery&, TaskMonitor&)>
      findInArchive;
  std::function<pacs::Received(const pacs::PacsNode&, const pacs::PacsSeries&,
                               const std::filesystem::path& folder, pacs::Retrieval, TaskMonitor&)>
      fetchFromArchive;
  /// Makes the case folder; replaces the model of a case that exists.
  std::function<void(const PrepareOrder&, TaskMonitor&)> prepareCase;
  /// Aligns from a recording's capture pair, or the one stored with the case, and stores the result in the
  /// case.
  std::function<workflow::AlignmentOutcome(const casefile::CaseStore&, const capture::Recording&,
                                           TaskMonitor&)>
      align;
  /// Cameras that are plugged in; quick.
  std::function<std::vector<capture::CameraDevice>()> listCameras;
  /// A live pair, by index; it releases both cameras when destroyed.
  std::function<std::unique_ptr<capture::FrameSource>(const stereo::StereoRig&, int left, int right)>
      openCameras;
  std::function<std::unique_ptr<session::Navigator>(const session::NavigatorSetup&)> makeNavigator;
  std::function<tracking::CoilModel(const std::filesystem::path&)> readCoil;
  /// The picture beside a brain model that was corrected by hand, in its case folder.
  std::function<void(const surface::DetailedCortex&, const surface::ModelDistance&,
                     const std::filesystem::path& case_folder)>
      drawSurfaceDistance;
  /// The labelled atlas; throws Error where it is not installed.
  std::function<atlas::BrainTemplate()> readTemplate;
  /// Written into provenance.
  std::string software_version;
};

}  // namespace facenav::ui
